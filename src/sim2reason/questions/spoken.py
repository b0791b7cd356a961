"""How questions say numbers, and how they are found in them again."""

import re
from functools import cache

import numpy as np

from sim2reason.dsl.measures import join_unit


def say(value: float, unit: str) -> str:
    """Two significant digits and the unit."""
    return join_unit(two_digits(value), unit)


def said(text: str, unit: str) -> list[float]:
    """The numbers of a unit that stand in a text."""
    return [float(number) for number in _number(unit).findall(text)]


@cache
def _number(unit: str) -> re.Pattern[str]:
    """A number as `say` has it: the degree sign follows without a space."""
    shown = join_unit("", unit)
    return re.compile(rf"(\d{{1,6}}(?:\.\d{{1,6}})?){re.escape(shown)}(?![\w/])")


ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth")


def ordinal(number: int) -> str:
    """Which of several, counted from one: *first*."""
    return ORDINALS[number - 1]


def numbers_of(text: str) -> list[int]:
    """The numbers whose ordinals stand in a text; 1 where there is none."""
    return [number for number, word in enumerate(ORDINALS, start=1) if re.search(rf"\b{word}\b", text)] or [1]


def two_digits(value: float) -> str:
    """A positive number with two significant digits, never in scientific notation."""
    rounded = float(f"{value:.1e}")
    places = max(0, 1 - int(np.floor(np.log10(rounded))))
    return f"{rounded:.{places}f}"


def spoken(value: float) -> float:
    """A positive number as it will be said."""
    return float(two_digits(value))
