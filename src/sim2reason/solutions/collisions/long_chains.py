"""Initial gaps between bodies, and steps of long chains of collisions combined into lists."""

import re
from collections.abc import Sequence
from dataclasses import replace

from sim2reason.scenes.dsl.frames import Frames
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.vectors import dot, minus
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.setting import capitalized, join_words
from sim2reason.solutions.solution import Step
from sim2reason.solutions.writing.lexicon import DualValue, Lexicon, UnreadError
from sim2reason.solutions.writing.merging import merge_group_into

Side = tuple[Frames, Mechanism]


def gap_at_start(lexicon: Lexicon, frames: tuple[Frames, Frames], number: int) -> Polynomial:
    """Return the initial gap of a pair, m; UnreadError if it is no simple function of the stated numbers.

    For a disc and a wall, the gap may be a sum of three lengths: the positions of wall and disc, and the radius.
    """
    sides: list[Side] = [(frames[0], lexicon.mechanism), (frames[1], lexicon.twin)]
    whole = DualValue(*(_place(*side, number) - side[1].meetings[number].distance for side in sides))
    try:
        return lexicon.read(whole)
    except UnreadError:
        found = _of_three(lexicon, whole) if lexicon.mechanism.meetings[number].a is None else None
        if found is None:
            raise
        return found


def _of_three(lexicon: Lexicon, whole: DualValue) -> Polynomial | None:
    """Return a gap as a stated length, or its negative, plus a sum of two lengths; None if no length fits."""
    for length in reversed(lexicon.lengths):
        for sign in (1.0, -1.0):
            try:
                rest = lexicon.read(whole - DualValue(sign * length.here, sign * length.there))
            except UnreadError:
                continue
            return lexicon.read(length).scaled(sign) + rest
    return None


def _place(frames: Frames, mechanism: Mechanism, number: int) -> float:
    """Return the position of a pair's second body along the normal, relative to the first or, for walls, the origin."""
    met = mechanism.meetings[number]
    assert met.normal is not None
    other = frames.center(met.b).place
    return float(dot(met.normal, other if met.a is None else minus(other, frames.center(met.a).place)))


MIN_NAMES_FOR_ROWS = 6  # names defined by steps of these kinds, from which on lists are easier to follow
VELOCITY, TIME, DISPLACEMENT = "velocity in flight", "time of flight", "displacement in flight"  # kinds of steps
GROUPED = VELOCITY, TIME, DISPLACEMENT
ROWS = {VELOCITY: "velocities", DISPLACEMENT: "displacements"}
SINGULAR = {"velocities": "velocity", "displacements": "displacement"}
INSTANT = re.compile(r"At (\$[^$]*\$) ")  # matches the time with which a sentence begins


def group_steps(steps: Sequence[Step]) -> list[Step]:
    """Return the steps of a long text with those of one kind combined; a short text is unchanged."""
    waiting = list(steps)
    if sum(len(step.gives) for step in waiting if step.kind in GROUPED) < MIN_NAMES_FOR_ROWS:
        return waiting
    told, found, place = set[int](), list[Step](), dict[int, int]()
    while waiting:
        group: list[Step] = [waiting.pop(0)]
        kind = group[0].kind
        told.add(group[0].id)
        while kind in GROUPED and (more := [s for s in waiting if s.kind == kind and told.issuperset(s.needs)]):
            group += more
            told.update(step.id for step in more)
            waiting = [step for step in waiting if step.id not in told]
        rows = group if kind == TIME else [_row(group)]  # times count from different events
        place |= {step.id: (step if kind == TIME else group[0]).id for step in group}
        found += rows
    return [replace(s, needs=tuple(sorted({place[n] for n in s.needs if n in place} - {s.id}))) for s in found]


def without_repeats(steps: Sequence[Step]) -> list[Step]:
    """Shorten or remove the sentences in steps about collisions that repeat an earlier step."""
    said, found = set[str](), list[Step]()
    for step in steps:
        text, (lead, *_) = step.text, step.text.split("$", 1)
        if step.kind == "impulse" and lead in said:
            text = text.replace(lead, "In the same way, ", 1)
        first, end, rest = text.partition(". ")
        if step.kind == "relative" and first in said:
            text = rest
        said |= {lead, first} if end else {lead}
        found.append(replace(step, text=text))
    return found


def _row(group: Sequence[Step]) -> Step:
    """Combine steps of one kind into one step that lists their formulas by instant; a single step is unchanged."""
    if group[0].kind not in ROWS or len(group) == 1:
        return group[0]
    rows: dict[str, list[str]] = {}
    for step in group:
        instants = set(INSTANT.findall(step.text))
        formulas = [f"${formula}$" for formula in step.text.split("$")[1::2][-len(step.gives) :]]
        rows.setdefault(instants.pop() if len(instants) == 1 else "", []).extend(formulas)
    noun = ROWS[group[0].kind]
    told = [
        f"{f'at {instant} ' if instant else ''}the {noun if len(formulas) > 1 else SINGULAR[noun]} "
        f"{'are' if len(formulas) > 1 else 'is'} {join_words(formulas)}"
        for instant, formulas in rows.items()
    ]
    return merge_group_into(group, f"{capitalized('; '.join(told))}.")
