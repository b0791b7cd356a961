"""Results that a question states, rounded to three digits."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache
from math import floor, log10
from typing import Self

from sim2reason.scenes.dsl.measures import join_unit

SMALLEST, LARGEST = -3, 4  # powers of ten between which a number needs no scientific notation
MINUS = "\N{MINUS SIGN}"


@dataclass(frozen=True, slots=True)
class StatedResult:
    """A number as the text states it, with its unit."""

    digits: str
    unit: str

    @classmethod
    def rounded(cls, value: float, unit: str, digits: int) -> Self | None:
        """Return a number rounded to significant digits; None if it would need scientific notation."""
        power = floor(log10(abs(float(f"{value:.{digits - 1}e}")))) if value else LARGEST + 1
        if not SMALLEST <= power <= LARGEST:
            return None
        places = digits - 1 - power
        return cls(f"{round(value, places):.{max(0, places)}f}".replace("-", MINUS), unit)

    @classmethod
    def found(cls, text: str, unit: str) -> Iterator[Self]:
        """Return all numbers with a given unit in a text."""
        return (cls(number, unit) for number in _number(unit).findall(text))

    @property
    def value(self) -> float:
        """Return the number as a float."""
        return float(self.digits.replace(MINUS, "-"))

    @property
    def half(self) -> float:
        """Return the largest rounding error that the digits imply; in large integers, only three digits count."""
        whole, _, decimals = self.digits.removeprefix(MINUS).partition(".")
        return 0.5 * 10.0 ** (-len(decimals) if decimals else max(0, len(whole) - 3))

    @property
    def said(self) -> str:
        """Return the number with its unit."""
        return join_unit(self.digits, self.unit)


@cache
def _number(unit: str) -> re.Pattern[str]:
    """Return a pattern for a number with its unit or, without a unit, one followed by no letter."""
    shown = join_unit("", unit)
    return re.compile(rf"(?<![\w.])({MINUS}?\d{{1,5}}(?:\.\d{{1,6}})?){re.escape(shown)}(?![\w/]|\.\d)")
