"""Olympiad problems with several questions, each worth some points: the share of the points that the answers earn.

HiPhO (Yu et al., 2025) at the level of answers: no points for steps. Numbers count within a relative tolerance, 5 %
as in this project, and expressions and equations by value.
"""

from collections.abc import Mapping
from typing import cast

from pydantic import JsonValue

from sim2reason.benchmarks.scoring import SCORINGS, Award, Reference, Scoring
from sim2reason.benchmarks.scoring.parts.answers import boxes, in_box
from sim2reason.benchmarks.scoring.parts.expressions import (
    equal_expressions,
    equivalent_equations,
    is_equation,
    same_text,
)
from sim2reason.benchmarks.scoring.parts.numbers import read, unit_or_none
from sim2reason.grading import number

__all__ = ["HiPhO"]

TOLERANCE = 0.05


class HiPhO(Scoring):
    """By the points of each question of a problem; the last boxes are its answers, in order."""

    def award(self, response: str, reference: Reference) -> Award:
        """By the reference's `parts`, each with `answer`, `unit` and `points`."""
        wanted = cast("list[Mapping[str, JsonValue]]", reference["parts"])
        found = boxes(response)[-len(wanted) :]
        if not found:
            return Award.unreadable("there is no box")
        if len(found) < len(wanted):
            return Award(0.0, parsed=", ".join(found), why=f"{len(found)} boxes where {len(wanted)} are asked")
        worth = [float(cast("float", part["points"])) for part in wanted]
        good = [_right(part, said) for part, said in zip(wanted, found, strict=True)]
        earned = sum(points for points, right in zip(worth, good, strict=True) if right) / sum(worth)
        return Award(earned, parsed=", ".join(found), why=f"right: {sum(good)} of {len(good)}")


def _right(part: Mapping[str, JsonValue], said: str) -> bool:
    answer, unit = str(part["answer"]), unit_or_none(part.get("unit"))
    if same_text(answer, said):
        return True
    if is_equation(answer):
        return bool(equivalent_equations(answer, said))
    value = read(answer, unit)
    if value is not None:
        return number(in_box(said), value, unit, tolerance=TOLERANCE).reward == 1.0
    return bool(equal_expressions(answer, said))


SCORINGS.add("hipho", HiPhO())
