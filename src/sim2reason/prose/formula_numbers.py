"""Numbers as formulas count them, in radians and metres, and as texts say them, in degrees and kilometres."""

from sim2reason.dsl.measures import join_unit
from sim2reason.dsl.units import parse_unit

DIGITS = 12  # of a number that was counted and is said again
MINUS = "\N{MINUS SIGN}"


def factor(unit: str) -> float:
    """What a number of some unit is multiplied by for a formula: 1 but for degrees and for kilometres."""
    return parse_unit(unit).factor if unit == "deg" or unit.startswith("km") else 1.0


def said_in(number: float, unit: str) -> str:
    """A number of a formula as a text has it: 30°, 2.5 kg."""
    plain = float(f"{number / factor(unit):.{DIGITS}g}")
    return join_unit(repr(plain).replace("-", MINUS), unit)
