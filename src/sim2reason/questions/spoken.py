"""How questions say numbers and pairs, and how numbers are found in them again."""

import re
from functools import cache

import numpy as np

from sim2reason.dsl.measures import show_unit


def pair(one: str, other: str) -> str:
    """Two bodies as one phrase: *pucks A and B*, *block A and wedge W*."""
    noun, _, letter = one.rpartition(" ")
    same, _, second = other.rpartition(" ")
    return f"{noun}s {letter} and {second}" if noun == same and noun != "the" else f"{one} and {other}"


def say(value: float, unit: str) -> str:
    """Two significant digits and the unit."""
    return f"{two_digits(value)} {show_unit(unit)}"


def said(text: str, unit: str) -> list[float]:
    """The numbers of a unit that stand in a text."""
    return [float(number) for number in _number(unit).findall(text)]


@cache
def _number(unit: str) -> re.Pattern[str]:
    return re.compile(rf"(\d{{1,6}}(?:\.\d{{1,6}})?) {re.escape(show_unit(unit))}(?![\w/])")


def two_digits(value: float) -> str:
    """A positive number with two significant digits, never in scientific notation."""
    rounded = float(f"{value:.1e}")
    places = max(0, 1 - int(np.floor(np.log10(rounded))))
    return f"{rounded:.{places}f}"


def spoken(value: float) -> float:
    """A positive number as it will be said."""
    return float(two_digits(value))
