"""How questions say numbers, and how they are found in them again."""

import re
from collections.abc import Collection
from dataclasses import dataclass
from decimal import Decimal
from functools import cache
from math import floor, isclose, log10

import numpy as np

from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.scenes.dsl.units import UnitSystem


@dataclass(frozen=True, slots=True)
class OwnSymbol:
    """What stands for a number that a question itself says: a noun with its article, its symbol, and its value."""

    noun: str
    symbol: str
    value: float

    @property
    def shown(self) -> str:
        """The symbol as it stands in a text."""
        return f"${self.symbol}$"


DIGITS = r"\d{1,20}"  # of a number before its point or after it: a float written in full has no more that matter
ROUND = (1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9)  # leading digits of the numbers that teachers choose
EXACT = 1e-13  # relative: numbers that differ by less are one
METRE, LONG, KILO = "m", 1e4, 1e3  # the unit of which so many are told as kilometres
OWN = {
    "s": ("a time", ("t", "t_1", "t_2")),
    "m": ("a distance", ("d", "s", "D")),
    "deg": ("an angle", (r"\alpha", r"\beta", r"\gamma")),
}
"""By the SI unit of a number of a question's own: its noun, and the symbols that it may have."""


def symbol_for(value: float, unit: str, taken: Collection[str]) -> OwnSymbol | None:
    """Return a symbol for a number of a question's own that nothing else has; None if there is none for its unit."""
    noun, options = OWN.get(unit, ("", ()))
    free = next((option for option in options if option not in taken), None)
    return OwnSymbol(noun, free, value) if free is not None else None


def spoken_of(symbol: str, said: str, units: UnitSystem) -> tuple[str, OwnSymbol] | None:
    """A symbol of a question's own from its number with the unit, and the SI unit; None if it can have no such."""
    for unit, (noun, options) in OWN.items():
        shown = join_unit("", units.spell(unit))
        if symbol in options and said.endswith(shown):
            return unit, OwnSymbol(noun, symbol, float(said.removesuffix(shown)))
    return None


def say(value: float, unit: str) -> str:
    """Return a number with all its digits, at least two, and its unit; lengths from 10 km on are in kilometres."""
    if unit == METRE and value >= LONG:
        return join_unit(digits(value / KILO), "km")
    return join_unit(digits(value), unit)


def said(text: str, unit: str) -> list[float]:
    """Return the numbers of a unit that stand in a text."""
    found = [float(number) for number in _number(unit).findall(text)]
    if unit == METRE:
        found += [float(Decimal(number) * int(KILO)) for number in _number("km").findall(text)]
    return found


@cache
def _number(unit: str) -> re.Pattern[str]:
    """Return a number as `say` has it: the degree sign follows without a space."""
    shown = join_unit("", unit)
    return re.compile(rf"({DIGITS}(?:\.{DIGITS})?){re.escape(shown)}(?![\w/])")


ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth")


def ordinal(number: int) -> str:
    """Return which of several, counted from one: *first*."""
    return ORDINALS[number - 1]


def numbers_of(text: str) -> list[int]:
    """Return the numbers whose ordinals stand in a text; 1 where there is none."""
    return [number for number, word in enumerate(ORDINALS, start=1) if re.search(rf"\b{word}\b", text)] or [1]


def two_digits(value: float) -> str:
    """Return a positive number with two significant digits, never in scientific notation."""
    rounded = float(f"{value:.1e}")
    places = max(0, 1 - int(np.floor(np.log10(rounded))))
    return f"{rounded:.{places}f}"


def digits(value: float) -> str:
    """Return a positive number with all its significant digits, at least two, and never in scientific notation."""
    two = two_digits(value)
    return two if isclose(float(two), value, rel_tol=EXACT) else f"{Decimal(f'{value:.15g}').normalize():f}"


def spoken(value: float) -> float:
    """Return a positive number as it will be said."""
    return float(two_digits(value))


def round_number(value: float, least: float, most: float) -> float:
    """Return the round number nearest to a positive one, such as 0.4, 1.5 or 25, that lies between two bounds.

    Where none does, the number is returned with two significant digits.
    """
    tens = floor(log10(value))
    found = [float(f"{mantissa}e{exponent}") for exponent in (tens - 1, tens, tens + 1) for mantissa in ROUND]
    fitting = [number for number in found if least <= number <= most]
    return min(fitting, key=lambda number: abs(log10(number / value)), default=spoken(value))
