"""The sums in formulas, and the signs that they have."""

from collections.abc import Iterator, Mapping
from math import copysign

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.expressions import Expression, Sum
from sim2reason.solutions.algebra.functions import values


def sums_in(held: Expression) -> Iterator[Sum]:
    """Yield all sums in a formula."""
    if isinstance(held, Sum):
        yield held
    for part in held.parts:
        yield from sums_in(part)


def sign_of(held: Expression, at: Mapping[str, float]) -> float | None:
    """1 or -1; None where a formula has no value."""
    try:
        return copysign(1.0, held.value(at).real)
    except (ValueError, ArithmeticError):
        return None


def turns(held: Expression, sign: float | None, at: Mapping[str, Array]) -> list[bool]:
    """For which of many numbers under each symbol, (m,), a formula has another sign, or none where it has one."""
    found = values(held, at)
    other = np.isfinite(found) if sign is None else np.isnan(found) | (np.copysign(1.0, found) != sign)
    return other.tolist()
