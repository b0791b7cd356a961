"""Numbers as formulas count them, in radians and metres, and as texts say them, in degrees and kilometres."""

from decimal import Decimal
from functools import cache

from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.scenes.dsl.unit_text import factors
from sim2reason.scenes.dsl.units import SYSTEMS, coherent, parse_unit

DIGITS = 12  # of a number that was counted and is said again
MINUS = "\N{MINUS SIGN}"
DEGREES, RADIANS = "deg", "rad"


@cache
def factor(unit: str) -> float:
    """Return what a number of some unit is multiplied by for a formula: 1 but for degrees and kilometres.

    Units of coherent systems other than the SI, such as those of astronomy, stand in formulas as they are.
    """
    own = frozenset[str]().union(*(system.own for system in SYSTEMS))
    return 1.0 if own & {word for word, _ in factors(unit)} else parse_unit(unit).factor


@cache
def counted_in(unit: str) -> str:
    """The unit of the numbers in formulas that a text says in `unit`: ``rad`` for ``deg``, ``m/s`` for ``km/s``."""
    if factor(unit) == 1.0:
        return unit
    words = ((RADIANS if word == DEGREES else word, power) for word, power in factors(unit))
    return coherent(" ".join(f"{word}^{power}" for word, power in words))[0]


def said_in(number: float, unit: str) -> str:
    """Return a number of a formula, in the unit that it has there, as a text says it: 30° for 0.5236 rad, 2.5 kg."""
    if unit == RADIANS:
        number, unit = number / factor(DEGREES), DEGREES
    plain = format(Decimal(f"{number:.{DIGITS}g}"), "f")  # no text has exponents
    return join_unit(plain.replace("-", MINUS), unit)
