"""Zero crossings of a function of the motion, bracketed on the steps of an engine and refined."""

from collections.abc import Callable, Iterator

import numpy as np

from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.trace import Trace

EventFunction = Callable[[State], Array]
"""A function of the state that is negative before and positive after what is looked for, (n,)."""

SMALL = 1e-9  # of the function's largest value: smaller values are zero
JUMP = 1e-12  # of the duration: a sign change within less is a jump at an event
CLOSE = 0.1  # of the error of a step: accuracy of a crossing time
ROUNDS = 16  # iterations of the refinement; three or four reach double precision
FINE = 33  # instants in an interval where the function may touch zero
_NEAR = 10.0 ** -np.arange(1.0, 9.0)


def crossings(trace: Trace, excess: EventFunction) -> Iterator[float]:
    """Yield the times, s, in order, at which a function rises through zero without a jump.

    What begins at zero must fall below it first. NaN is neither below nor above.
    """
    times, values = _sampled(trace, excess)
    size = np.abs(values)[np.isfinite(values)].max(initial=0.0)
    above, below = values >= 0.0, values < -SMALL * size
    was_below = False
    for number in range(1, len(times)):
        was_below = was_below or bool(below[number - 1])
        if not above[number] or not was_below:
            continue
        was_below = False
        low, high = float(times[number - 1]), float(times[number])
        if values[number - 1] >= 0.0:
            continue  # it lost its value on the way, and has it again
        if high - low <= JUMP * float(times[-1]):
            if values[number] - values[number - 1] <= SMALL * size:
                yield high  # an event, such as a turn, at which nothing jumps
        else:
            yield _refine_root(trace, excess, (low, float(values[number - 1])), (high, float(values[number])))


def first_crossing(trace: Trace, excess: EventFunction) -> float | None:
    """Return the first time, s, at which a function rises through zero in the simulated motion; else None."""
    return next(crossings(trace, excess), None)


def jumps(trace: Trace, excess: EventFunction) -> list[float]:
    """Return the times, s, in order, of events at which a function jumps from negative to positive."""
    times, values = trace.scan.times, excess(trace.scan)
    small = SMALL * np.abs(values)[np.isfinite(values)].max(initial=0.0)
    jumped = (np.diff(times) <= JUMP * float(times[-1])) & (values[:-1] < -small) & (values[1:] > small)
    found: list[float] = times[1:][jumped].tolist()
    return found


def rises_from_zero(trace: Trace, excess: EventFunction) -> bool:
    """Return whether a function is zero at the start and positive when it first differs from zero."""
    values = excess(trace.scan)
    size = np.abs(values)[np.isfinite(values)].max(initial=0.0)
    clear = values[np.abs(values) > SMALL * size]
    return bool(abs(values[0]) <= SMALL * size and len(clear) and clear[0] > 0.0)


def _sampled(trace: Trace, excess: EventFunction) -> tuple[Array, Array]:
    """Return sampled times and values of a function, with more samples where it may touch zero between two of them."""
    times = trace.scan.times
    values = excess(trace.scan)
    if len(times) < 3:
        return times, values
    sizes = np.abs(values)
    nearest = np.flatnonzero((sizes[1:-1] <= sizes[:-2]) & (sizes[1:-1] <= sizes[2:]))
    before, here, after = values[nearest], values[nearest + 1], values[nearest + 2]
    bend = before - 2.0 * here + after
    with np.errstate(divide="ignore", invalid="ignore"):
        rise = np.abs((after - before) ** 2 / (8.0 * bend)) + np.abs(bend) / 8.0  # of a parabola over its middle sample
    same = (before * here > 0.0) & (after * here > 0.0) & (np.sign(bend) == np.sign(here))
    close = nearest[same & (np.abs(here) < 2.0 * rise)]
    if not len(close):
        return times, values
    closer: list[Array] = [np.linspace(times[i], times[i + 2], FINE)[1:-1] for i in close.tolist()]
    more: Array = np.setdiff1d(np.concatenate(closer), times)
    order = np.argsort(joined := np.concatenate([times, more]))
    return joined[order], np.concatenate([values, excess(trace.sample(more))])[order]


def _refine_root(trace: Trace, excess: EventFunction, low: tuple[float, float], high: tuple[float, float]) -> float:
    """Return the time, s, of a sign change between two instants, by the secant method with bracketing."""
    (a, fa), (b, fb) = low, high
    for _ in range(ROUNDS):
        width = b - a
        if width <= max(4e-16, CLOSE * trace.tolerance) * b:
            break
        guess = a - width * fa / (fb - fa)
        around = np.concatenate([guess - width * _NEAR, [guess], guess + width * _NEAR, a + width * _EIGHTHS])
        times = np.sort(np.clip(around, a, b))  # what is there twice does no harm
        values = excess(trace.sample(times))
        reached = int(np.argmax((values >= 0.0) | (times >= b)))
        if reached == 0:
            return float(times[0])
        a, b, fa, fb = (float(x) for x in (times[reached - 1], times[reached], values[reached - 1], values[reached]))
        if not fb > fa:
            break
    return b


_EIGHTHS = np.arange(0.0, 1.01, 0.125)
