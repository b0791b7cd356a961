"""Monotonic formulas: an equation whose side increases or decreases throughout has a single root."""

from collections.abc import Mapping
from itertools import pairwise

import numpy as np

from sim2reason.solutions.algebra.expressions import Expression

SPAN, SAMPLES, LEAST = 1e3, 160, 20  # times the symbol's value and one over it; places, and how many must have values


def trend(formula: Expression, name: str, values: Mapping[str, float]) -> str:
    """Return ``increases`` or ``decreases`` if a formula does so at all places that are tried, else nothing.

    Places of the sign of the symbol's value are tried; the formula may have values at some of them alone.
    """
    found: list[float] = []
    for place in (values[name] * np.geomspace(1.0 / SPAN, SPAN, SAMPLES)).tolist():
        try:
            value = formula.value({**values, name: place})
        except (ValueError, ArithmeticError):
            continue
        if isinstance(value, float):
            found.append(value)
    steps = [after - before for before, after in pairwise(found)]
    if len(steps) < LEAST or values[name] <= 0.0:
        return ""
    if all(step > 0.0 for step in steps):
        return "increases"
    return "decreases" if all(step < 0.0 for step in steps) else ""
