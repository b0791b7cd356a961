"""Steps that say the same of several names, in one sentence: *After it, this is so, and that*."""

import re
from collections.abc import Sequence
from dataclasses import replace

from sim2reason.solutions.setting import joined
from sim2reason.solutions.solution import Step

BEGIN = frozenset({"other value", "names"})
"""The kinds of steps that begin a second case or name new unknowns; what follows does not stand before them."""
SENTENCE = re.compile(r"(?P<lead>((At|After the time|In the time) \$[^$]*\$)?[^$]*) (?P<formulas>\$[^$]*\$)\.")

SINGULAR_PLURAL = "the displacement is", "the displacements are"


def merged(steps: Sequence[Step]) -> list[Step]:
    """Steps of one like sentence as one step where the first of them stands, which rests on all that the others do."""
    groups: list[list[Step]] = []
    place: dict[int, int] = {}  # by the number of a step, that of the one with which it stands
    start = 0
    for step in steps:
        start = len(groups) if step.kind in BEGIN else start
        held = replace(step, needs=tuple(sorted({place[n] for n in step.needs if n in place})))
        group = next((group for group in groups[start:] if _alike(group[0], held, follows=group is groups[-1])), None)
        if group is None:
            groups.append(group := [])
        group.append(held)
        place[step.id] = group[0].id
    return [_said(group) for group in groups]


def _alike(first: Step, other: Step, *, follows: bool) -> bool:
    """Return whether a later step can stand with an earlier one: it says the same, of what is known by then.

    A step that `follows` directly may rest on all that is known by then; another one on no more than the earlier one.
    """
    one, two = SENTENCE.fullmatch(first.text), SENTENCE.fullmatch(other.text)
    said = one is not None and two is not None and one["lead"] == two["lead"]
    known = {*other.needs} == {*first.needs} or bool(other.needs and {*other.needs} < {*first.needs})
    known = known or (follows and all(number < first.id for number in other.needs))
    return (
        said and (first.kind, first.phase) == (other.kind, other.phase) and known and bool(first.gives and other.gives)
    )


def _said(group: Sequence[Step]) -> Step:
    """Steps with one lead: that, and the formulas of all."""
    if len(group) == 1:
        return group[0]
    matches = [match for step in group if (match := SENTENCE.fullmatch(step.text)) is not None]
    lead = matches[0]["lead"].replace(*SINGULAR_PLURAL)
    return together(group, f"{lead} {joined([match['formulas'] for match in matches])}.")


def together(group: Sequence[Step], text: str) -> Step:
    """Several steps as one with a text of its own, where the first of them stands."""
    return replace(
        group[0],
        text=text,
        relations=tuple(relation for step in group for relation in step.relations),
        gives=tuple(name for step in group for name in step.gives),
        needs=tuple(sorted({n for step in group for n in step.needs})),
    )
