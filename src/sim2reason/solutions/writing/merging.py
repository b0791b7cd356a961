"""The merging of steps with equal sentences into one: *After it, v = 2 m/s and s = 1 m*."""

import re
from collections.abc import Sequence
from dataclasses import replace

from sim2reason.solutions.setting import join_words
from sim2reason.solutions.solution import Step

BEGIN = frozenset({"other value", "names"})
"""Kinds of steps that begin a second case or name new unknowns; later steps are not moved before them."""
SENTENCE = re.compile(r"(?P<lead>((At|After the time|In the time) \$[^$]*\$)?[^$]*) (?P<formulas>\$[^$]*\$)\.")

SINGULAR_PLURAL = "the displacement is", "the displacements are"


def merged(steps: Sequence[Step]) -> list[Step]:
    """Return steps in which those with like sentences form one step at the position of the first."""
    groups: list[list[Step]] = []
    place: dict[int, int] = {}  # from the number of a step to that of the step with which it is merged
    start = 0
    for step in steps:
        start = len(groups) if step.kind in BEGIN else start
        held = replace(step, needs=tuple(sorted({place[n] for n in step.needs if n in place})))
        group = next((group for group in groups[start:] if _alike(group[0], held, follows=group is groups[-1])), None)
        if group is None:
            groups.append(group := [])
        group.append(held)
        place[step.id] = group[0].id
    return [_merge_group(group) for group in groups]


def _alike(first: Step, other: Step, *, follows: bool) -> bool:
    """Return whether a later step can be merged with an earlier one: same words, and no use of results in between.

    A step that `follows` directly may use all earlier results; another one no more than the first step does.
    """
    one, two = SENTENCE.fullmatch(first.text), SENTENCE.fullmatch(other.text)
    said = one is not None and two is not None and one["lead"] == two["lead"]
    known = {*other.needs} == {*first.needs} or bool(other.needs and {*other.needs} < {*first.needs})
    known = known or (follows and all(number < first.id for number in other.needs))
    return (
        said and (first.kind, first.phase) == (other.kind, other.phase) and known and bool(first.gives and other.gives)
    )


def _merge_group(group: Sequence[Step]) -> Step:
    """Combine steps whose sentences differ only in their formulas into one step with all formulas."""
    if len(group) == 1:
        return group[0]
    matches = [match for step in group if (match := SENTENCE.fullmatch(step.text)) is not None]
    lead = matches[0]["lead"].replace(*SINGULAR_PLURAL)
    return merge_group_into(group, f"{lead} {join_words([match['formulas'] for match in matches])}.")


def merge_group_into(group: Sequence[Step], text: str) -> Step:
    """Combine several steps into one with a given text and the number of the first."""
    return replace(
        group[0],
        text=text,
        relations=tuple(relation for step in group for relation in step.relations),
        gives=tuple(name for step in group for name in step.gives),
        needs=tuple(sorted({n for step in group for n in step.needs})),
    )
