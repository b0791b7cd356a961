"""Simulation and certification of scenes, and truncation of traces by statistics of their samples.

An engine ends a trace by physics, and two engines by certificate (`certify`). The third method, by statistics, is for a
trace of one engine alone: an outlier in a window of samples indicates a transition. On whole traces it finds every
collision; between the events that an engine reports it should find nothing, and any finding there is an alarm.

A smooth motion has outliers, too, as at the perihelion of a long orbit. A smooth function becomes straight under
magnification, and a transition does not: if an engine can evaluate its motion at other times, this is tested before a
sample counts.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from itertools import pairwise
from math import isfinite
from typing import NamedTuple
from warnings import warn

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from numpy.typing import NDArray

from sim2reason.errors import MotionEndsWarning, SceneError
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.files import SceneLike, as_scene
from sim2reason.simulation.certify import RECORDED, Certificate
from sim2reason.simulation.certify import certify as certify_mechanism
from sim2reason.simulation.trace import ENGINES, Trace, ending

Flags = NDArray[np.bool_]

WINDOW_SAMPLES = 50  # samples; with w samples no |aᵢ − µ| exceeds √w·σ, so under 26 none reaches 5σ
MAX_DEVIATIONS = 5.0
BEND_FACTOR = 8.0  # times the local median of the third difference
COLUMN_FLOOR = 1e-6  # fraction of a column's largest value, or of 1: smaller values are round-off
PIECES, ZOOMS = 32, 2  # pieces of an interval, and how often three of them are subdivided again
STRAIGHTENING_FACTOR = 1.0 / 33.0  # in three of 32 pieces a parabola's bend shrinks to 1/114, a corner's to 1/11
BEND_ROUNDING = 1e-9  # fraction of the largest value there: a smaller bend is round-off


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


def truncate_trace(trace: Trace, window: int = WINDOW_SAMPLES) -> Trace:
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


def alarms(trace: Trace, window: int = WINDOW_SAMPLES) -> tuple[Alarm, ...]:
    """Return the jumps that the 5σ or the third-difference rule finds between the events of a trace, in order."""
    jumps: list[Alarm] = []
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
                    jumps.append(Alarm(first[1], column.name, rule))
    return tuple(sorted(jumps))


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
        if not bends[-1] > BEND_ROUNDING * max(1.0, float(np.abs(values).max())):
            return True
        middle, piece = float(times[most + 1]), (high - low) / PIECES
        low, high = max(low, middle - 1.5 * piece), min(high, middle + 1.5 * piece)
    return bends[-1] <= STRAIGHTENING_FACTOR * bends[-2]


def _floor(values: Array) -> float:
    return COLUMN_FLOOR * max(1.0, float(np.abs(values).max(initial=0.0)))


def _deviations(values: Array, window: int) -> list[tuple[int, int]]:
    """Return the 5σ outliers of all windows, earliest window first, each as an interval of one sample."""
    if window < WINDOW_SAMPLES:
        raise ValueError(f"a window of {window} samples is too short; take at least {WINDOW_SAMPLES}")
    if len(values) < window or not np.isfinite(values).all():
        return []
    windows = sliding_window_view(values, window)
    deviations = np.abs(windows - windows.mean(axis=1, keepdims=True))
    out: Flags = deviations >= np.maximum(MAX_DEVIATIONS * windows.std(axis=1, keepdims=True), _floor(values))
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
    out: Flags = third > np.maximum(BEND_FACTOR * nearby, _floor(values))
    return [(number, number + 3) for number in np.flatnonzero(out).tolist()]


DEFAULT_SAMPLES = 101
BOTH = "both"
"""Engine name for the trace of the exact engine, checked by the other."""


def certify(
    scene: SceneLike, duration: float | None = None, samples: int = DEFAULT_SAMPLES
) -> tuple[Trace, Certificate]:
    """Simulate a scene with both engines and compare the two motions.

    Args:
        scene: A scene, the path of its file, its YAML text, an item about it, or the result of `parse_scene`.
        duration: Duration in the scene's unit of time (s unless its text uses another); by default its horizon.
        samples: Number of instants, at equal intervals from 0 to `duration`.

    Returns:
        The trace of the exact engine, cut where the engines part, and the certificate with their differences.

    Raises:
        TypeError: `scene` is of another type.
        SceneError, UnsupportedError, SimulationError: The scene cannot be built, modelled or solved.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> trace, certificate = sim2reason.certify(scene, duration=1.0)
        >>> certificate.stable_until
        1.0
        >>> max(certificate.agreement.values()) < 1e-9
        True
    """
    scene = as_scene(scene, "certify")
    return certify_mechanism(scene.mechanism, _times(scene, duration, samples))


def simulate(
    scene: SceneLike,
    duration: float | None = None,
    engine: str = RECORDED,
    samples: int = DEFAULT_SAMPLES,
    *,
    truncate: bool = False,
) -> Trace:
    """Simulate a scene with one engine, and record the motion at equal intervals.

    The last state is at `stable_until`, where the description of the motion ends. If that is before the requested
    `duration`, a MotionEndsWarning gives the reason.

    Args:
        scene: A scene, the path of its file, its YAML text, an item about it, or the result of `parse_scene`.
        duration: Duration in the scene's unit of time (s unless its text uses another); by default its horizon.
        engine: ``exact``, ``mujoco``, or ``both``: the trace of the exact engine, cut where the engines part.
        samples: Number of instants, at equal intervals from 0 to `duration`.
        truncate: Whether to cut the trace where a sample deviates by five standard deviations, events included.

    Returns:
        The motion, its events, and the time until which it is valid.

    Raises:
        TypeError: `scene` is of another type.
        UnknownNameError: There is no such engine.
        SceneError, UnsupportedError, SimulationError: The scene cannot be built, modelled or solved.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.parse_scene("A 2 kg block is released from rest on a frictionless 30-degree incline.")
        >>> trace = sim2reason.simulate(scene, duration=1.0, samples=3)
        >>> trace.state.times
        array([0. , 0.5, 1. ])
        >>> abs(trace.state.v[:, 0]).round(6)  # a block on a smooth slope has v = g t sin 30°
        array([0.  , 2.45, 4.9 ])
    """
    scene = as_scene(scene, "simulate")
    trace = simulate_full_duration(scene, duration, engine, samples)
    trace = truncate_trace(trace) if truncate else trace
    if duration is not None and trace.stable_until < duration:
        unit = scene.units.time
        problem = f"the motion is described until {trace.stable_until:.6g} {unit}, not {duration:g} {unit}"
        warn(f"{problem}: {ending(trace)}; the record ends there", MotionEndsWarning, stacklevel=2)
    return trace.until(trace.stable_until)


def simulate_full_duration(
    scene: Scene, duration: float | None = None, engine: str = RECORDED, samples: int = DEFAULT_SAMPLES
) -> Trace:
    """Simulate a scene for the whole duration, as plots need; states after `stable_until` are invalid."""
    if engine == BOTH:
        return certify(scene, duration, samples)[0]
    return ENGINES[engine](scene.mechanism, _times(scene, duration, samples))


def _times(scene: Scene, duration: float | None, samples: int) -> Array:
    duration = scene.horizon if duration is None else duration
    if not (isfinite(duration) and duration > 0.0 and samples > 1):
        problem = f"{duration} {scene.units.time} in {samples} samples is no record"
        raise SceneError("duration", problem, "give a positive, finite duration and at least two samples")
    return np.linspace(0.0, duration, samples)
