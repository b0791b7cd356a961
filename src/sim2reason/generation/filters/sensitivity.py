"""Drops a question that too few of the stated numbers matter for, or too many do not."""

from collections.abc import Iterator

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.generation.filters.parts.effects import effects
from sim2reason.generation.filters.parts.numbers import (
    EVER,
    Given,
    elasticities,
    givens,
    matters,
    of_question,
    shifted,
    shortfall,
)
from sim2reason.scenes.dsl.mechanism import Mechanism

COUNTED = 2  # numbers with which a count must change
IDLE = {"easy": 0.0, "medium": 0.1, "hard": 0.1}  # of what is given: how much may have no bearing, unmarked


class Sensitivity(Filter):
    """Too few numbers move the answer, or too many do not.

    What belongs to a part without bearing is told apart: the item marks it as a distraction. So are the mass and the
    charge of what is asked about and the radius of what rolls, which may well cancel, and what the kind of question is
    indifferent to.
    """

    order = 7

    def reason(self, candidate: Candidate) -> str:
        """Count those that move it beyond the tolerance when they are halved or doubled."""
        scene, query = candidate.study.scene, candidate.question.query
        given = [given for given in givens(scene, candidate.question.left_open) if given.owner != "world"]
        aside = [effect.subject for effect in effects(candidate, part=True) if effect.close]
        own = {path for name in query.subjects for path in _cancelling(candidate.study.mechanism, name)}
        excused = [g for g in given if own & {*g.paths} or any(_belongs(g, name) for name in aside)]
        counted = candidate.kind.measured(query).whole  # which changes with some of the numbers only
        told = len(given) + of_question(candidate)
        moving, idle = list[Given](), list[Given]()
        for found in elasticities(candidate):
            if found.given in given:
                (moving if matters(candidate, found) else idle).append(found.given)
            if len(idle) > EVER * told:
                return f"idle numbers: {_paths(idle)}"
            unmarked = [g for g in idle if g not in excused and not _is_indifferent(candidate, g)]
            if not counted and len(unmarked) > IDLE[candidate.difficulty] * len(given):
                return f"idle numbers: {_paths(unmarked)}"
        if counted:
            return "" if len(moving) >= COUNTED else f"reach: the count changes with {len(moving)} numbers"
        short = shortfall(candidate, moving)
        return f"reach: {short}" if short else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield how the answer moves with each number."""
        for found in elasticities(candidate):
            moved = "matters" if matters(candidate, found) else "does not matter"
            yield f"{', '.join(found.given.paths)}: |d ln answer / d ln number| = {found.size:.3g}; it {moved}"


def _paths(found: list[Given]) -> str:
    return ", ".join(path for given in found for path in given.paths)


def _is_indifferent(candidate: Candidate, given: Given) -> bool:
    """Return whether such answers by nature do not depend on it, as a period on how far a spring is pulled."""
    other = shifted(candidate.study, given, candidate.until)
    return other is not None and candidate.kind.indifferent(candidate.question.query, candidate.study, other)


def _cancelling(mechanism: Mechanism, subject: str) -> set[str]:
    """The addresses of what may well cancel: mass and charge of what is asked about, and the radius of what rolls."""
    body = _lone(mechanism, subject)
    rolls = body in mechanism.contacts and len(mechanism.contacts[body].slip) > 1
    return {f"{body}.mass", f"{body}.charge", *([f"{body}.radius"] if rolls else [])}


def _lone(mechanism: Mechanism, subject: str) -> str:
    """The only body with mass that moves as one with the subject, such as the bob on its rod; else the subject."""
    frame = _carrier(mechanism, subject)
    found = [body.name for body in mechanism.bodies if body.mass and _carrier(mechanism, body.name) == frame]
    return found[0] if frame and len(found) == 1 else subject


def _carrier(mechanism: Mechanism, name: str | None) -> str:
    """The body with coordinates that a body is, or is fixed to; empty for what is no body or fixed in the room."""
    body = mechanism.body.get(name or "")
    if body is None:
        return ""
    return body.name if body.coordinates else _carrier(mechanism, body.parent)


def _belongs(given: Given, name: str) -> bool:
    """Return whether it is a number of the part of that name."""
    return any(path.startswith(f"{name}.") for path in given.paths)


FILTERS.add("sensitivity", Sensitivity())
