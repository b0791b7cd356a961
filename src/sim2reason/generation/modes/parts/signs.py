"""Sums in formulas, and their signs."""

from collections.abc import Iterator, Mapping
from math import copysign

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.expressions import Expression, Sum
from sim2reason.solutions.algebra.functions import array_values


def sums_in(held: Expression) -> Iterator[Sum]:
    """Yield all sums in a formula."""
    if isinstance(held, Sum):
        yield held
    for part in held.parts:
        yield from sums_in(part)


def sign_of(held: Expression, at: Mapping[str, float]) -> float | None:
    """Return the sign of a formula's value, 1 or -1; None where it has no value."""
    try:
        return copysign(1.0, held.value(at).real)
    except (ValueError, ArithmeticError):
        return None


def turns(held: Expression, sign: float | None, at: Mapping[str, Array]) -> list[bool]:
    """Return, for each set of numbers (m,), whether a formula's value differs in sign from `sign`, or is undefined."""
    found = array_values(held, at)
    other = np.isfinite(found) if sign is None else np.isnan(found) | (np.copysign(1.0, found) != sign)
    return other.tolist()
