"""When something first reaches a value."""

from collections.abc import Callable

import numpy as np

from sim2reason.dsl.state import Array

SCAN = 64  # samples in the search for the first crossing; motions are piecewise parabolas, so none is missed
STEPS = 60  # halvings of an interval: below any double's resolution


def first_crossing(excess: Callable[[Array], Array], end: float) -> float | None:
    """The first time in (0, end] at which a function that starts below zero reaches zero; None if it does not."""
    low, high = 0.0, end
    for _ in range(STEPS):  # each round narrows the interval by the number of samples
        times = np.linspace(low, high, SCAN)
        above = np.flatnonzero(excess(times) >= 0.0)
        if len(above) == 0:
            return None
        first = int(above[0])
        if first == 0:
            return low if low > 0.0 else None
        low, high = float(times[first - 1]), float(times[first])
        if high - low <= 4e-16 * end:
            break
    return high
