"""Numbers in answers, read as our grader reads them, and compared as a benchmark says."""

from sim2reason.benchmarks.scoring.parts.answers import in_box
from sim2reason.dsl.units import UnitError, parse_unit
from sim2reason.grading import Outcome, number
from sim2reason.grading.unit_spelling import unit_in

__all__ = ["read", "unit_or_none"]


def read(content: str, unit: str | None = None, *, expected: float = 1.0) -> float | None:
    """The one number that an answer says, in `unit` where that is known; None if it says none, or in no such unit.

    `expected` decides how a direction without a sign is read.
    """
    found = number(in_box(content), expected, unit)
    return (
        found.parsed if found.outcome in {Outcome.CORRECT, Outcome.WRONG} and isinstance(found.parsed, float) else None
    )


def unit_or_none(text: object) -> str | None:
    """The name of a unit of our table; None for one that it does not hold, and where none is said."""
    if not isinstance(text, str) or not text.strip(" $"):
        return None
    try:
        return parse_unit(unit_in(text.strip(" $"), None).name).name
    except UnitError:
        return None
