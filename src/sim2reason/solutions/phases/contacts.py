"""Rough contacts in a phase of constant acceleration: which way friction acts, and what the normal force is called."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.phases.equations import PhaseEquations
from sim2reason.solutions.phases.pruning import LAWS
from sim2reason.solutions.setting import capital
from sim2reason.solutions.solution import Step
from sim2reason.solutions.writing.steps import Book

CONTACT = "contact"  # the kind of these steps, each about one face
_NAMED = re.compile(r"\$([^$]*)\$")


def tell_contacts(inner: PhaseEquations, book: Book, forces: Mapping[str, Symbol]) -> None:
    """Write for each rough face what slips or sticks there, the direction of friction, and what forces are called."""
    for face, side in inner.rough.items():
        step, who = book.open(CONTACT), inner.setting.called(inner.mechanism.faces[face].subject)
        step.say(_slipping(inner, face, side, who, forces) if side else _sticking(inner, face, who, forces))
        turning = inner.turning_inertia(face)
        if turning:
            step.say(f"The moment of inertia of {who} about its axis is ${turning}$.")
        step.close()


def _slipping(inner: PhaseEquations, face: int, side: int, who: str, forces: Mapping[str, Symbol]) -> str:
    """Return the directions of slip and of friction, and the name of the normal force."""
    ways, under = [_way(inner, face, sign) for sign in (side, -side)], _under(inner, face)
    slides, where = ("slips", " at the point of contact") if inner.is_round(face) else ("slides", "")
    normal = f"the normal force on {who} is ${forces[f'normal{face}'].latex()}$."
    if not all(ways):
        return capital(normal)
    return f"{capital(who)} {slides} {ways[0]}{where}{under}, so the friction on it acts {ways[1]}; {normal}"


def _sticking(inner: PhaseEquations, face: int, who: str, forces: Mapping[str, Symbol]) -> str:
    """Return that nothing slips, and the name of the static friction, with the direction in which it is positive."""
    way, holds = _way(inner, face, 1), "rolls without slipping" if inner.is_round(face) else "does not slip"
    counted = f", counted positive {way}," if way else ""
    return f"{capital(who)} {holds}; the static friction on it{counted} is ${forces[f'friction{face}'].latex()}$."


def with_used_contacts(steps: Sequence[Step]) -> list[Step]:
    """Return steps without contacts whose forces the laws that follow do not have."""
    found: list[Step] = []
    for number, step in enumerate(steps):
        if step.kind == CONTACT:
            laws = next((held for held in steps[number:] if held.kind == LAWS), None)
            used = {*laws.symbols()} if laws is not None else set[str]()
            if used.isdisjoint(_NAMED.findall(step.text)):
                step = replace(step, text="")  # noqa: PLW2901
        found.append(step)
    return found


def _way(inner: PhaseEquations, face: int, sense: int) -> str:
    """Return the direction in which a body slips on a face, in words; empty if it has none."""
    m = inner.mechanism
    slides = [(m.number[name], part) for name, part in m.faces[face].slip]
    slides = [(k, part) for k, part in slides if m.coordinates[k].kind == "slide"]
    if not slides:
        return ""
    k, part = slides[0]
    sign = 1.0 if sense * part > 0.0 else -1.0
    x, y, z = m.coordinates[k].axis
    body = m.coordinates[k].body
    return inner.setting.towards((sign * x, sign * y, sign * z), on=m.body[body].parent)


def _under(inner: PhaseEquations, face: int) -> str:
    """Return a reminder that the surface moves, too, if it does."""
    m = inner.mechanism
    slides = [name for name, _ in m.faces[face].slip if m.coordinates[m.number[name]].kind == "slide"]
    return " relative to the surface under it" if len(slides) > 1 else ""
