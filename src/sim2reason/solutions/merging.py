"""Steps that say the same of several names, in one sentence: *After it, this is so, and that*."""

import re
from collections.abc import Sequence
from dataclasses import replace

from sim2reason.solutions.setting import joined
from sim2reason.solutions.solution import Step

SENTENCE = re.compile(r"(?P<lead>[^$]*) (?P<formulas>\$[^$]*\$)\.")


def merged(steps: Sequence[Step]) -> list[Step]:
    """Steps of one like sentence that rest on the same ones, as one step where the first of them stands."""
    groups: dict[tuple[object, ...], list[Step]] = {}
    place: dict[int, int] = {}  # by the number of a step, that of the one with which it stands
    for step in steps:
        rests = tuple(sorted({place.get(n, n) for n in step.needs}))
        match = SENTENCE.fullmatch(step.text)
        key = (step.kind, match["lead"], rests) if match is not None and step.gives else (step.id,)
        group = groups.setdefault(key, [])
        group.append(replace(step, needs=rests))
        place[step.id] = group[0].id
    return [_together(group) for group in groups.values()]


def _together(group: Sequence[Step]) -> Step:
    if len(group) == 1:
        return group[0]
    matches = [match for step in group if (match := SENTENCE.fullmatch(step.text)) is not None]
    return replace(
        group[0],
        text=f"{matches[0]['lead']} {joined([match['formulas'] for match in matches])}.",
        relations=tuple(relation for step in group for relation in step.relations),
        gives=tuple(name for step in group for name in step.gives),
    )
