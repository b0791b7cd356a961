"""Values in several units, such as *1 m 20 cm*, *1 h 5 min 20 s* or 26°30′, in decreasing order."""

import re
from typing import Final

from sim2reason.grading.remarks import printed
from sim2reason.grading.unit_spelling import unit_in
from sim2reason.scenes.dsl.units import Unit, UnitError, parse_unit

__all__ = ["smaller_part"]

SIXTY: Final = 60  # minutes in a degree, and seconds in a minute

_PARTS: Final = re.compile(
    r"\s*(?P<unit>[A-Za-z]{1,12})(?P<rest>(?:\s*[0-9]{1,4}(?:\.[0-9]{1,6})?\s*[A-Za-z]{1,12}){1,3})\s*"
)
_PART: Final = re.compile(r"([0-9.]+)\s*([A-Za-z]+)")
_ARC: Final = re.compile(
    r"\s*(?:\^\s*\\circ|\^\s*\{\s*\\circ\s*\}|\^?°|\\degree)\s*(?P<minutes>[0-9]{1,2}(?:\.[0-9]{1,6})?)"
    r"\s*(?:['′]|\^?\s*\{?\s*\\prime\s*\}?)"
    r"(?:\s*(?P<seconds>[0-9]{1,2}(?:\.[0-9]{1,6})?)\s*(?:''|″|′′|\"|\^?\s*\{?\s*\\prime\s*\\prime\s*\}?))?\s*"
)


def smaller_part(whole: str, tail: str, asked: Unit | None) -> tuple[Unit, float] | None:
    """Return the first unit of a value such as 1 h 5 min, and the amount of the smaller parts in that unit.

    None if there is no such value, or if the same number occurs with two units, which is ambiguous.
    """
    if not whole.isdecimal():
        return None
    if arc := _ARC.fullmatch(re.sub(r"\\[ ,;:!]", " ", tail)):
        return _of_arc(arc)
    found = _PARTS.fullmatch(printed(tail))
    if found is None:
        return None
    parts = _PART.findall(found["rest"])
    return None if len(parts) == 1 and parts[0][0] == whole else _added(found["unit"], parts, asked)


def _added(whole: str, parts: list[tuple[str, str]], asked: Unit | None) -> tuple[Unit, float] | None:
    """Return the first unit and the sum of the smaller parts in that unit; None if a part is not smaller than one."""
    try:
        unit, *smaller = [unit_in(word, asked) for word in (whole, *(word for _, word in parts))]
    except UnitError:
        return None
    total, last = 0.0, 1.0
    for (number, _), below in zip(parts, smaller, strict=True):
        factor = below.factor_to(unit)
        share = float(number) * factor if factor is not None else last
        if share >= last:  # more than one of the unit before it
            return None
        total, last = total + share, factor or last
    return unit, total


def _of_arc(found: re.Match[str]) -> tuple[Unit, float] | None:
    """Return the degree as a unit, and the minutes and seconds of arc in degrees; None if either is 60 or more."""
    minutes, seconds = float(found["minutes"]), float(found["seconds"] or 0)
    return (parse_unit("deg"), minutes / 60 + seconds / 3600) if max(minutes, seconds) < SIXTY else None
