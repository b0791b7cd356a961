"""Truncation of a trace by statistics of its samples.

An engine ends a trace by physics, and two engines by certificate (`certify`). This module is the third method, by
statistics, for a trace of one engine alone: an outlier in a window of samples indicates a transition. On whole traces
it finds every collision; between the events that an engine reports it should find nothing, and any finding there is
an alarm.

A smooth motion has outliers, too, as at the perihelion of a long orbit. A smooth function becomes straight under
magnification, and a transition does not: if an engine can evaluate its motion at other times, this is tested before a
sample counts.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.trace import Trace

Flags = NDArray[np.bool_]

WINDOW = 50  # samples; with w samples no |aᵢ − µ| exceeds √w·σ, so under 26 none reaches 5σ
DEVIATIONS = 5.0
BENDS = 8.0  # times the local median of the third difference
FLOOR = 1e-6  # fraction of a column's largest value, or of 1: smaller values are round-off
PIECES, ZOOMS = 32, 2  # pieces of an interval, and how often three of them are subdivided again
STRAIGHT = 1.0 / 33.0  # in three of 32 pieces a parabola's bend shrinks to 1/114, a corner's to 1/11
ROUNDING = 1e-9  # fraction of the largest value there: a smaller bend is round-off


class Alarm(NamedTuple):
    """A sample with a transition that no reported event explains."""

    time: float  # s
    column: str  # such as "acceleration of block.slide"
    rule: str  # "deviation" or "third difference"


class Column(NamedTuple):
    """A value that jumps at a transition: an acceleration, a force, or the rate of change of a velocity."""

    name: str
    read: Callable[[State], Array]
    change: bool = False  # whether the difference between successive samples is judged

    def values(self, state: State, chosen: Flags) -> Array:
        """Return the values at the chosen samples, or the rates of change of the values if `change` is set."""
        read = self.read(state)[chosen]
        return np.diff(read) / np.diff(state.times[chosen]) if self.change else read


def truncate(trace: Trace, window: int = WINDOW) -> Trace:
    """Return the trace, truncated at the first sample of a force or acceleration that deviates 5σ from its mean.

    The rule of the paper: over a window, max |aᵢ − µ| ≥ 5σ. It is applied to every acceleration and force in
    the trace, events or no events. Raises ValueError for a window in which it can't fire.
    """
    times = trace.state.times
    usable = times <= trace.stable_until
    span = (0.0, trace.stable_until)
    found = [
        first
        for column in _columns(trace.mechanism, trace.state)
        if (first := _first(trace, column, usable, _deviations(column.values(trace.state, usable), window), span))
    ]
    if not found:
        return trace
    until = min(float(times[max(0, number - 1)]) for number, _ in found)
    return replace(trace, stable_until=until, cut="statistics")


def alarms(trace: Trace, window: int = WINDOW) -> tuple[Alarm, ...]:
    """Return the jumps that the 5σ or the third-difference rule finds between the events of a trace, in order."""
    found: list[Alarm] = []
    times = trace.state.times
    for start, stop in _segments(trace):
        inside = (times > start) & (times < stop)
        for column in _columns(trace.mechanism, trace.state):
            values = column.values(trace.state, inside)
            for rule, flags in (
                ("deviation", _deviations(values, window)),
                ("third difference", _bends(values, window)),
            ):
                first = _first(trace, column, inside, flags, (max(start, 0.0), stop))
                if first is not None:
                    found.append(Alarm(first[1], column.name, rule))
    return tuple(sorted(found))


def _segments(trace: Trace) -> list[tuple[float, float]]:
    borders = [-1.0, *(event.time for event in trace.events if event.changes_motion), trace.stable_until]
    within = sorted(min(border, trace.stable_until) for border in borders)
    return [(a, b) for a, b in pairwise(within) if b > a]


def _columns(mechanism: Mechanism, state: State) -> Iterator[Column]:
    """Yield the values that jump at a transition: accelerations, changes of velocities, and all known forces."""
    for number, coordinate in enumerate(mechanism.coordinates):
        yield Column(f"acceleration of {coordinate.name}", partial(_acceleration, number))
        yield Column(f"change of velocity of {coordinate.name}", partial(_velocity, number), change=True)
    for name in state.tension:
        yield Column(f"tension of {name}", partial(_tension, name))
    for name in state.normal:
        yield Column(f"normal force of {name}", partial(_normal, name))
        yield Column(f"friction of {name}", partial(_friction, name))


def _acceleration(number: int, state: State) -> Array:
    return state.a[:, number]


def _velocity(number: int, state: State) -> Array:
    return state.v[:, number]


def _tension(name: str, state: State) -> Array:
    return state.tension[name]


def _normal(name: str, state: State) -> Array:
    return state.normal[name]


def _friction(name: str, state: State) -> Array:
    return state.friction[name]


def _first(
    trace: Trace, column: Column, chosen: Flags, flags: list[tuple[int, int]], span: tuple[float, float]
) -> tuple[int, float] | None:
    """Return the index and the time, s, of the first flagged sample that is not on a smooth curve; else None."""
    numbers = np.flatnonzero(chosen)[1 if column.change else 0 :]
    times = trace.state.times
    for first, last in flags:
        low, high = times[numbers[max(0, first - 1)]], times[numbers[min(len(numbers) - 1, last + 1)]]
        if not _smooth(trace, column, max(float(low), span[0]), min(float(high), float(np.nextafter(span[1], 0.0)))):
            return int(numbers[last]), float(times[numbers[last]])
    return None


def _smooth(trace: Trace, column: Column, low: float, high: float) -> bool:
    """Return whether a column of values becomes straight under magnification where its curve bends most."""
    bends: list[float] = []
    for _ in range(ZOOMS + 1):
        times = np.linspace(low, high, PIECES + 1)
        try:
            values = column.read(trace.sample(times))
        except ValueError:
            return False  # a trace that was read from a file knows nothing but its samples
        bend = np.abs(np.diff(values, 2))
        most = int(bend.argmax())
        bends.append(float(bend[most]))
        if not bends[-1] > ROUNDING * max(1.0, float(np.abs(values).max())):
            return True
        middle, piece = float(times[most + 1]), (high - low) / PIECES
        low, high = max(low, middle - 1.5 * piece), min(high, middle + 1.5 * piece)
    return bends[-1] <= STRAIGHT * bends[-2]


def _floor(values: Array) -> float:
    return FLOOR * max(1.0, float(np.abs(values).max(initial=0.0)))


def _deviations(values: Array, window: int) -> list[tuple[int, int]]:
    """Return the 5σ outliers of all windows, earliest window first, each as an interval of one sample."""
    if window < WINDOW:
        raise ValueError(f"a window of {window} samples is too short; take at least {WINDOW}")
    if len(values) < window or not np.isfinite(values).all():
        return []
    windows = sliding_window_view(values, window)
    apart = np.abs(windows - windows.mean(axis=1, keepdims=True))
    out: Flags = apart >= np.maximum(DEVIATIONS * windows.std(axis=1, keepdims=True), _floor(values))
    first, within = np.nonzero(out)
    return [(number, number) for number in dict.fromkeys((first + within).tolist())]


def _bends(values: Array, window: int) -> list[tuple[int, int]]:
    """Return the intervals of four samples whose third difference is far above its local median, in order."""
    if len(values) < 4 or not np.isfinite(values).all():
        return []
    third = np.abs(np.diff(values, 3))
    width = min(window, len(third))
    medians = np.median(sliding_window_view(third, width), axis=1)
    nearby = medians[np.clip(np.arange(len(third)) - width // 2, 0, len(medians) - 1)]
    out: Flags = third > np.maximum(BENDS * nearby, _floor(values))
    return [(number, number + 3) for number in np.flatnonzero(out).tolist()]
