"""A value in two units, as people measure: *1 m 20 cm*, *2 min 5 s*. The second unit is the smaller one of the same."""

import re
from typing import Final

from sim2reason.dsl.units import Unit, UnitError
from sim2reason.grading.remarks import printed
from sim2reason.grading.unit_spelling import unit_in

__all__ = ["smaller_part"]

_PARTS: Final = re.compile(
    r"\s*(?P<unit>[A-Za-z]{1,12})\s*(?P<number>[0-9]{1,4}(?:\.[0-9]{1,6})?)\s*(?P<smaller>[A-Za-z]{1,12})\s*"
)


def smaller_part(whole: str, tail: str, asked: Unit | None) -> tuple[Unit, float] | None:
    """The unit of a whole number, and what the text behind adds to that number; None if it is no such text.

    The same number twice is none either: that offers two units to choose from.
    """
    found = _PARTS.fullmatch(printed(tail)) if whole.isdecimal() else None
    if found is None or found["number"] == whole:
        return None
    try:
        unit, smaller = unit_in(found["unit"], asked), unit_in(found["smaller"], asked)
    except UnitError:
        return None
    factor = smaller.factor_to(unit)
    part = float(found["number"]) * factor if factor is not None else 1.0
    return (unit, part) if part < 1.0 else None
