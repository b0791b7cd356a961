"""A root of a function of one number between two points at which it has opposite signs."""

from collections.abc import Callable

ROUNDS = 200
PATIENCE = 4  # rounds in which the interval should at least be halved
EPSILON = 2.3e-16


def bracketed_root(function: Callable[[float], float], low: float, high: float) -> float:
    """A root between `low`, where the function is positive, and `high`, where it is not.

    Regula falsi, in the form that halves the value of an end that stays (Illinois): M. Dowell, P. Jarratt, A modified
    regula falsi method for computing the root of an equation (1971); and by bisection where that is slow.
    """
    if low == high:
        return low
    above, below = function(low), function(high)
    if above <= 0.0:
        return low
    side, width = 0, high - low
    for number in range(ROUNDS):
        middle = (low * below - high * above) / (below - above)
        slow = number % PATIENCE == PATIENCE - 1 and high - low > 0.5 * width  # one end never moves at a flat root
        if slow or not low < middle < high:
            middle = 0.5 * (low + high)
        if number % PATIENCE == PATIENCE - 1:
            width = high - low
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
