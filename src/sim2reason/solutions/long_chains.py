"""Long chains of hits: velocities and displacements are told in rows, as soon as all is known that they hang on."""

import re
from collections.abc import Sequence
from dataclasses import replace

from sim2reason.solutions.setting import joined
from sim2reason.solutions.solution import Step

LONG = 10  # sentences of these kinds, from which on a text is easier to follow with rows
ROWS = {
    "Velocities:": re.compile(r"(Then|After this time,) the velocity of [^$]* is (\$[^$]*\$(, | and )?)+\."),
    "Times:": re.compile(r"(That is at|Since then) (\$[^$]*\$(, | and )?)+( have passed)?\."),
    "Displacements:": re.compile(r"Until then [^$]* moves by (\$[^$]*\$(, | and )?)+\."),
}
FORMULA = re.compile(r"\$[^$]*\$")


def in_rows(steps: Sequence[Step]) -> list[Step]:
    """A long text with sentences of one kind put together where the first of them stands; any other as it is."""
    waiting = list(steps)
    if sum(1 for step in waiting if _row(step)) < LONG:
        return waiting
    told, found, place = set[int](), list[Step](), dict[int, int]()
    while waiting:
        group = [waiting.pop(0)]
        row = _row(group[0])
        told.add(group[0].id)
        while row and (more := [s for s in waiting if _row(s) == row and told.issuperset(s.needs)]):
            group += more
            told.update(step.id for step in more)
            waiting = [step for step in waiting if step.id not in told]
        place |= dict.fromkeys((step.id for step in group), group[0].id)
        found.append(_together(row, group))
    return [replace(s, needs=tuple(sorted({place[n] for n in s.needs if n in place} - {s.id}))) for s in found]


def _row(step: Step) -> str:
    return next((lead for lead, shape in ROWS.items() if shape.fullmatch(step.text)), "")


def _together(row: str, group: Sequence[Step]) -> Step:
    if len(group) == 1:
        return group[0]
    formulas = [formula for step in group for formula in FORMULA.findall(step.text)]
    return replace(
        group[0],
        text=f"{row} {joined(formulas)}.",
        relations=tuple(relation for step in group for relation in step.relations),
        gives=tuple(name for step in group for name in step.gives),
        needs=tuple(sorted({n for step in group for n in step.needs})),
    )
