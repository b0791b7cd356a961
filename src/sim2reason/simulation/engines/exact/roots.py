"""Roots of a function of one number, in an interval whose ends it has different signs at."""

from collections.abc import Callable

ROUNDS = 100
EPSILON = 2.3e-16


def first_root(function: Callable[[float], float], low: float, high: float) -> float:
    """A root between `low`, where the function is positive, and `high`, where it is not.

    Regula falsi, in the form that halves the value of an end that stays (Illinois): M. Dowell, P. Jarratt, A modified
    regula falsi method for computing the root of an equation (1971).
    """
    if low == high:
        return low
    above, below = function(low), function(high)
    if above <= 0.0:
        return low
    side = 0
    for _ in range(ROUNDS):
        middle = (low * below - high * above) / (below - above)
        if not low < middle < high:
            middle = 0.5 * (low + high)
        value = function(middle)
        if value > 0.0:
            low, above = middle, value
            below = 0.5 * below if side == 1 else below
            side = 1
        else:
            high, below = middle, value
            above = 0.5 * above if side == -1 else above
            side = -1
        if value == 0.0 or high - low <= 4.0 * EPSILON * max(abs(low), abs(high)):
            break
    return high
