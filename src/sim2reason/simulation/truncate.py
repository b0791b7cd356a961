"""Where a trace stops being usable, as its samples tell.

By physics an engine ends a trace itself, and by certificate two engines do (`certify`). Here is the third
way, by statistics, for a trace of one engine alone: a sample that stands out from its window tells of a
transition. On whole traces that finds every collision; between the events that an engine reports nothing
should be left to find, and what is found there is an alarm.
"""

from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from sim2reason.dsl.state import Array
from sim2reason.simulation.trace import Trace

Flags = NDArray[np.bool_]

WINDOW = 50  # samples; with w samples no |aᵢ − µ| exceeds √w·σ, so under 26 none reaches 5σ
DEVIATIONS = 5.0
BENDS = 8.0  # times the local median of the third difference
FLOOR = 1e-6  # of a column's largest value, or of 1: less is rounding


class Alarm(NamedTuple):
    """A sample that nothing which the engine reports explains."""

    time: float  # s
    column: str  # such as "acceleration of block.slide"
    rule: str  # "deviation" or "third difference"


def truncate(trace: Trace, window: int = WINDOW) -> Trace:
    """The trace, to be used no longer than the paper's rule finds nothing in it.

    The rule: over a window, max |aᵢ − µ| ≥ 5σ. It is applied to every acceleration and force in
    the trace, events or no events. Raises ValueError for a window in which it can't fire.
    """
    times = trace.state.times
    usable = times <= trace.stable_until
    first = min((_deviation(column, window) for column in _columns(trace, usable).values()), default=len(times))
    if first >= int(usable.sum()):
        return trace
    until = float(times[first - 1]) if first else 0.0
    return replace(trace, stable_until=until, cut="statistics")


def alarms(trace: Trace, window: int = WINDOW) -> tuple[Alarm, ...]:
    """Unmodelled transitions: what both rules find between one event of the trace and the next, in order of time."""
    found: list[Alarm] = []
    times = trace.state.times
    for start, stop in _segments(trace):
        inside = (times > start) & (times < stop)
        when = times[inside]
        for name, values in _columns(trace, inside).items():
            for rule, first in (("deviation", _deviation(values, window)), ("third difference", _bend(values, window))):
                if first < len(values):
                    found.append(Alarm(float(when[first]), name, rule))
    return tuple(sorted(found))


def _segments(trace: Trace) -> list[tuple[float, float]]:
    borders = [-1.0, *(event.time for event in trace.events if event.kind != "turn"), trace.stable_until]
    within = sorted(min(border, trace.stable_until) for border in borders)
    return [(a, b) for a, b in pairwise(within) if b > a]


def _columns(trace: Trace, chosen: Flags) -> dict[str, Array]:
    """What jumps at a transition, at chosen samples: accelerations, also as v changes, and all forces known."""
    state, columns = trace.state, dict[str, Array]()
    times = state.times[chosen]
    for number, coordinate in enumerate(trace.mechanism.coordinates):
        speed = state.v[chosen, number]
        columns[f"acceleration of {coordinate.name}"] = state.a[chosen, number]
        if len(times) > 1:
            change = np.diff(speed) / np.diff(times)
            columns[f"change of velocity of {coordinate.name}"] = np.append(change[:1], change)
    for kind, forces in (("tension", state.tension), ("normal force", state.normal), ("friction", state.friction)):
        columns |= {f"{kind} of {name}": values[chosen] for name, values in forces.items()}
    return {name: values for name, values in columns.items() if np.isfinite(values).all()}


def _floor(values: Array) -> float:
    return FLOOR * max(1.0, float(np.abs(values).max(initial=0.0)))


def _deviation(values: Array, window: int) -> int:
    """The sample that stands out in the first window that has one, or the number of samples."""
    if window < WINDOW:
        raise ValueError(f"a window of {window} samples is too short; take at least {WINDOW}")
    if len(values) < window:
        return len(values)
    windows = sliding_window_view(values, window)
    apart = np.abs(windows - windows.mean(axis=1, keepdims=True))
    out: Flags = apart >= np.maximum(DEVIATIONS * windows.std(axis=1, keepdims=True), _floor(values))
    first = int(out.any(axis=1).argmax())
    return first + int(out[first].argmax()) if out[first].any() else len(values)


def _bend(values: Array, window: int) -> int:
    """The first sample at which the third difference is far above its median nearby, or the number of samples."""
    third = np.abs(np.diff(values, 3))
    if not len(third):
        return len(values)
    width = min(window, len(third))
    medians = np.median(sliding_window_view(third, width), axis=1)
    nearby = medians[np.clip(np.arange(len(third)) - width // 2, 0, len(medians) - 1)]
    out: Flags = third > np.maximum(BENDS * nearby, _floor(values))
    return int(np.flatnonzero(out)[0]) + 3 if out.any() else len(values)
