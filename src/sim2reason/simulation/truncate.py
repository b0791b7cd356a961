"""Where a trace stops being usable, as its samples tell.

By physics an engine ends a trace itself, and by certificate two engines do (`certify`). Here is the third
way, by statistics, for a trace of one engine alone: a sample that stands out from its window tells of a
transition. On whole traces that finds every collision; between the events that an engine reports nothing
should be left to find, and what is found there is an alarm.

A smooth motion has samples that stand out, too, as at the perihelion of a long orbit. What is smooth becomes
straight when it is looked at closely, and a transition does not: where an engine can give its motion at other
times, that is asked before a sample counts.
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
FLOOR = 1e-6  # of a column's largest value, or of 1: less is rounding
PIECES, ZOOMS = 32, 2  # into how many pieces an interval is cut, and how often three of these are again
STRAIGHT = 1.0 / 33.0  # as three of 32 pieces are looked at, a parabola's bend shrinks to 1/114, a corner's to 1/11
ROUNDING = 1e-9  # of the largest value there: a smaller bend is rounding


class Alarm(NamedTuple):
    """A sample that nothing which the engine reports explains."""

    time: float  # s
    column: str  # such as "acceleration of block.slide"
    rule: str  # "deviation" or "third difference"


class Column(NamedTuple):
    """What jumps at a transition: an acceleration, a force, or a velocity whose change is judged."""

    name: str
    read: Callable[[State], Array]
    change: bool = False  # it is the change from one sample to the next that is judged

    def values(self, state: State, chosen: Flags) -> Array:
        """Return what is judged, at chosen samples; a change stands at the later of its two."""
        read = self.read(state)[chosen]
        return np.diff(read) / np.diff(state.times[chosen]) if self.change else read


def truncate(trace: Trace, window: int = WINDOW) -> Trace:
    """Return the trace, to be used no longer than the paper's rule finds nothing in it.

    The rule: over a window, max |aᵢ − µ| ≥ 5σ. It is applied to every acceleration and force in
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
    """Unmodelled transitions: what both rules find between one event of the trace and the next, in order of time."""
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
    """Yield what jumps at a transition: accelerations, also as v changes, and all forces known."""
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
    """Return the first flagged sample that is no smooth curve's, by its number in the trace and its time, s."""
    numbers = np.flatnonzero(chosen)[1 if column.change else 0 :]
    times = trace.state.times
    for first, last in flags:
        low, high = times[numbers[max(0, first - 1)]], times[numbers[min(len(numbers) - 1, last + 1)]]
        if not _smooth(trace, column, max(float(low), span[0]), min(float(high), float(np.nextafter(span[1], 0.0)))):
            return int(numbers[last]), float(times[numbers[last]])
    return None


def _smooth(trace: Trace, column: Column, low: float, high: float) -> bool:
    """Return whether a column becomes straight between two instants as one looks closer at where it bends the most."""
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
    """The samples that stand out in the first window that has any, then in later ones, each as a stretch of itself."""
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
    """Return the stretches of four samples whose third difference is far above its median nearby, in order."""
    if len(values) < 4 or not np.isfinite(values).all():
        return []
    third = np.abs(np.diff(values, 3))
    width = min(window, len(third))
    medians = np.median(sliding_window_view(third, width), axis=1)
    nearby = medians[np.clip(np.arange(len(third)) - width // 2, 0, len(medians) - 1)]
    out: Flags = third > np.maximum(BENDS * nearby, _floor(values))
    return [(number, number + 3) for number in np.flatnonzero(out).tolist()]
