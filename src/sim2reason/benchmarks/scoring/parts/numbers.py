"""Numbers in answers, read as our grader reads them, and compared as a benchmark says."""

from sim2reason.benchmarks.scoring.parts.answers import in_box
from sim2reason.dsl.units import Unit, UnitError, parse_unit
from sim2reason.grading import Outcome, number
from sim2reason.grading.number import unit_stated
from sim2reason.grading.unit_spelling import unit_in

__all__ = ["agrees", "read", "unit_or_none"]


def read(content: str, unit: str | Unit | None = None, *, expected: float = 1.0) -> float | None:
    """The one number that an answer says, in `unit` where that is known; None if it says none, or in no such unit.

    `expected` decides how a direction without a sign is read.
    """
    found = number(in_box(content), expected, unit)
    return (
        found.parsed if found.outcome in {Outcome.CORRECT, Outcome.WRONG} and isinstance(found.parsed, float) else None
    )


def agrees(right: str, said: str, tolerance: float) -> bool | None:
    """Return whether two answers give the same number, within a tolerance relative to the right answer.

    None where the right answer is no number. Its unit holds for both; without a unit, the other's unit is ignored.
    """
    stated = unit_stated(right)
    unit = stated if stated is not None and any(stated.dimension) else None
    value, other = read(right, unit), read(said, unit)
    if value is None:
        return None
    return other is not None and abs(other - value) <= tolerance * abs(value)


def unit_or_none(text: object) -> str | None:
    """The name of a unit of our table; None for one that it does not hold, and where none is said."""
    if not isinstance(text, str) or not text.strip(" $"):
        return None
    try:
        return parse_unit(unit_in(text.strip(" $"), None).name).name
    except UnitError:
        return None
