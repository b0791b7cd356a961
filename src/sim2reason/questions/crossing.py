"""When something reaches a value: looked for on the engine's own steps, and closed in on between two of them."""

from collections.abc import Callable, Iterator

import numpy as np

from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.trace import Trace

Excess = Callable[[State], Array]
"""A function of the state that is negative before and positive after what is looked for, (n,)."""

SMALL = 1e-9  # of the function's largest value: less is nothing
JUMP = 1e-12  # of the duration: a function that changes sign within less jumps, at an event
CLOSE = 0.1  # of what a step errs by: no need to know the time much better
ROUNDS = 16  # of closing in; three or four reach the resolution of doubles
FINE = 33  # instants where the function may touch zero between two samples
_NEAR = 10.0 ** -np.arange(1.0, 9.0)


def crossings(trace: Trace, excess: Excess) -> Iterator[float]:
    """Yield the times, s, at which a function that was below zero comes up through zero, without a jump, in order.

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
            yield _closed_in(trace, excess, (low, float(values[number - 1])), (high, float(values[number])))


def first_crossing(trace: Trace, excess: Excess) -> float | None:
    """Return the first of the `crossings`; None if there is none while the motion is described."""
    return next(crossings(trace, excess), None)


def jumps(trace: Trace, excess: Excess) -> list[float]:
    """Return the times, s, of events at which a function jumps from below zero to above, in order."""
    times, values = trace.scan.times, excess(trace.scan)
    small = SMALL * np.abs(values)[np.isfinite(values)].max(initial=0.0)
    jumped = (np.diff(times) <= JUMP * float(times[-1])) & (values[:-1] < -small) & (values[1:] > small)
    found: list[float] = times[1:][jumped].tolist()
    return found


def begins_beyond(trace: Trace, excess: Excess) -> bool:
    """Return whether a function begins at zero and rises first, as a rate does where the start is a turning point."""
    values = excess(trace.scan)
    size = np.abs(values)[np.isfinite(values)].max(initial=0.0)
    clear = values[np.abs(values) > SMALL * size]
    return bool(abs(values[0]) <= SMALL * size and len(clear) and clear[0] > 0.0)


def _sampled(trace: Trace, excess: Excess) -> tuple[Array, Array]:
    """The function on the trace's scan, and more closely where it may touch zero between three samples of one sign."""
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


def _closed_in(trace: Trace, excess: Excess, low: tuple[float, float], high: tuple[float, float]) -> float:
    """When the sign changes between two instants, each with its value: by secants, and points around their roots."""
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
