"""Numbers as formulas count them, in radians and metres, and as texts say them, in degrees and kilometres."""

from functools import cache

from sim2reason.dsl.measures import join_unit
from sim2reason.dsl.unit_text import factors
from sim2reason.dsl.units import SYSTEMS, parse_unit

DIGITS = 12  # of a number that was counted and is said again
MINUS = "\N{MINUS SIGN}"


@cache
def factor(unit: str) -> float:
    """What a number of some unit is multiplied by for a formula: 1 but for degrees and kilometres.

    Units of coherent systems other than the SI, such as those of astronomy, stand in formulas as they are.
    """
    own = frozenset[str]().union(*(system.own for system in SYSTEMS))
    return 1.0 if own & {word for word, _ in factors(unit)} else parse_unit(unit).factor


def said_in(number: float, unit: str) -> str:
    """A number of a formula as a text has it: 30°, 2.5 kg."""
    plain = float(f"{number / factor(unit):.{DIGITS}g}")
    return join_unit(repr(plain).replace("-", MINUS), unit)
