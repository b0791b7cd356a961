"""Numerical search for the values of an unknown at which formulas have a given value."""

from math import isfinite, pi

import numpy as np

from sim2reason.solutions.algebra.evaluated import Chain, ImplicitRoot
from sim2reason.solutions.writing.steps import SolutionBuilder
from sim2reason.solutions.writing.unit_latex import DEGREES

SEARCH_POINTS = 801  # samples of the range of an unknown
SEARCH_RATIO = 1e4  # ratio of the largest and smallest value of the range to the known value
BISECTION_STEPS = 60  # steps of bisection
POLE_RATIO = 1e-3  # relative to the values beside a change of sign: larger residuals are those of a pole


def is_explicit(chain: Chain) -> bool:
    """Return whether no formula of a chain is a root of an implicit equation, so that all can be evaluated directly."""
    return not any(isinstance(formula, ImplicitRoot) for _, formula in chain.formulas)


def values_with(chain: Chain, target: float, unknown: str, book: SolutionBuilder) -> list[float]:
    """Return the values of an unknown, in SI units, at which the last formula of a chain equals `target`.

    The search covers values with the sign of the known value; angles up to 90°, coefficients of restitution up to 1.
    """

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
            for _ in range(BISECTION_STEPS):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if off(middle) * off(low) > 0.0 else (low, middle)
            if abs(off(low)) <= POLE_RATIO * max(abs(sides[n]), abs(sides[n + 1])):
                found.append(0.5 * (low + high))
    return found


def is_restitution(name: str, book: SolutionBuilder) -> bool:
    """Return whether a symbol is a coefficient of restitution, which is at most 1."""
    return name.partition("_")[0] == "e" and not book.units[name] and 0.0 < book.values[name] <= 1.0


def range_text(unknown: str, book: SolutionBuilder) -> str:
    """Return the range in which an unknown was searched for, in words such as *positive $m$*."""
    name = f"${unknown}$"
    if book.units[unknown] == DEGREES:
        return f"{name} between $0^\\circ$ and $90^\\circ$"
    if is_restitution(unknown, book):
        return f"{name} between 0 and 1"
    return f"{'negative' if book.values[unknown] < 0.0 else 'positive'} {name}"


def _points(unknown: str, book: SolutionBuilder) -> list[float]:
    """Return the sample values of an unknown, in SI units, between which its other solutions are searched for."""
    known = book.values[unknown]
    if book.units[unknown] == DEGREES and 0.0 < known < 0.5 * pi:
        return np.linspace(0.0, 0.5 * pi, SEARCH_POINTS).tolist()
    if is_restitution(unknown, book):
        return np.linspace(0.0, 1.0, SEARCH_POINTS).tolist()
    return (known * np.geomspace(1.0 / SEARCH_RATIO, SEARCH_RATIO, SEARCH_POINTS)).tolist()
