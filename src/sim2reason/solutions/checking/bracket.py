"""The zero of a function between two points at which it has different signs."""

from collections.abc import Callable

HALVINGS = 200
EPS = 4e-16  # relative


def zero(function: Callable[[float], float], one: float, other: float, *, within: float = EPS) -> float:
    """Find a zero by the method of Anderson and Björck, with bisection where that is slow.

    The values at both points must differ in sign; the zero is found `within` a relative distance. What the function
    raises is passed on.
    """
    low, high = function(one), function(other)
    for n in range(HALVINGS):
        if not low:
            return one
        if not high or abs(other - one) <= within * max(abs(one), abs(other)):
            return other
        middle = other - high * (other - one) / (high - low) if n % 4 < 3 else 0.5 * (one + other)
        if not min(one, other) < middle < max(one, other):
            middle = 0.5 * (one + other)
        value = function(middle)
        if (value > 0.0) == (high > 0.0):  # the other end stays: count it for less
            weight = 1.0 - value / high
            low *= weight if weight > 0.0 else 0.5
        else:
            one, low = other, high
        other, high = middle, value
    return other
