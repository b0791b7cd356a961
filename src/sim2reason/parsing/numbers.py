"""Numbers and symbols as texts write them."""

import re
from decimal import Decimal

from sim2reason.dsl.units import coherent

POWER = " \N{MULTIPLICATION SIGN} 10^"
NUMBER = re.compile(
    "\N{MINUS SIGN}?[0-9]{1,40}(?:\\.[0-9]{1,40})?"
    f"(?:e[+\N{MINUS SIGN}]?[0-9]{{1,3}}|{re.escape(POWER)}\N{MINUS SIGN}?[0-9]{{1,3}})?"
)
SYMBOL = re.compile(r"\$([^$\n]{1,40})\$")


def meanings(digits: str, unit: str) -> list[tuple[str, float]]:
    """The units that may stand behind a number, each with the number's value in `unit`.

    What is declared in km/s may be told in m/s, too.
    """
    number = digits.replace("\N{MINUS SIGN}", "-").replace(POWER, "e")
    bare, size = coherent(unit)
    told = [(unit, float(number))]
    return told if size == 1 else [*told, (bare, float(Decimal(number) / size))]
