"""For which values of an unknown formulas come to a given number, looked for in all that it could be."""

from math import isfinite, pi

import numpy as np

from sim2reason.solutions.algebra.evaluated import Chain, ImplicitRoot
from sim2reason.solutions.writing.steps import Book
from sim2reason.solutions.writing.unit_latex import DEGREES

POINTS = 801
REACH = 1e4  # times its value, either way
HALVINGS = 60
NEAR = 1e-3  # of the larger of two values on either side of a zero: a pole leaves more


def is_explicit(chain: Chain) -> bool:
    """Return whether formulas have values anywhere: none of them is a root that was found near another value."""
    return not any(isinstance(formula, ImplicitRoot) for _, formula in chain.formulas)


def values_with(chain: Chain, target: float, unknown: str, book: Book) -> list[float]:
    """Return the values of an unknown, of its sign, for which the last formula comes to a number."""

    def off(value: float) -> float:
        try:
            found = chain.value({**book.values, unknown: value})
        except (ValueError, ArithmeticError):
            return float("nan")
        return found - target if isinstance(found, float) else float("nan")

    points = _points(unknown, book)
    sides = [off(point) for point in points]
    found: list[float] = []
    for n in range(len(points) - 1):
        ends = isfinite(sides[n]) and isfinite(sides[n + 1])
        if ends and (sides[n] * sides[n + 1] < 0.0 or sides[n + 1] == 0.0 or (n == 0 and sides[n] == 0.0)):
            low, high = points[n], points[n + 1]
            for _ in range(HALVINGS):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if off(middle) * off(low) > 0.0 else (low, middle)
            if abs(off(low)) <= NEAR * max(abs(sides[n]), abs(sides[n + 1])):
                found.append(0.5 * (low + high))
    return found


def told_range(unknown: str, book: Book) -> str:
    """Return what an unknown could be, in words, as in: *no positive $m$*."""
    name = f"${unknown}$"
    if book.units[unknown] == DEGREES:
        return f"{name} between $0^\\circ$ and $90^\\circ$"
    if _is_coefficient(unknown, book):
        return f"{name} between 0 and 1"
    return f"{'negative' if book.values[unknown] < 0.0 else 'positive'} {name}"


def _points(unknown: str, book: Book) -> list[float]:
    known = book.values[unknown]
    if book.units[unknown] == DEGREES and 0.0 < known < 0.5 * pi:
        return np.linspace(0.0, 0.5 * pi, POINTS).tolist()
    if _is_coefficient(unknown, book):
        return np.linspace(0.0, 1.0, POINTS).tolist()
    return (known * np.geomspace(1.0 / REACH, REACH, POINTS)).tolist()


def _is_coefficient(unknown: str, book: Book) -> bool:
    return unknown.partition("_")[0] == "e" and not book.units[unknown] and 0.0 < book.values[unknown] <= 1.0
