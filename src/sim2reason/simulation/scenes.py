"""Simulating and certifying scenes rather than mechanisms."""

from math import isfinite
from warnings import warn

import numpy as np

from sim2reason.dsl.scene import Scene
from sim2reason.dsl.state import Array
from sim2reason.errors import MotionEndsWarning, SceneError
from sim2reason.scene_files import SceneLike, scene_of
from sim2reason.simulation.certify import RECORDED, Certificate
from sim2reason.simulation.certify import certify as certify_mechanism
from sim2reason.simulation.trace import ENGINES, Trace, ending
from sim2reason.simulation.truncate import truncate as truncated

SAMPLES = 101
BOTH = "both"
"""In place of an engine's name: one checked by the other."""


def certify(scene: SceneLike, duration: float | None = None, samples: int = SAMPLES) -> tuple[Trace, Certificate]:
    """Simulate a scene with both engines for `duration`, by default its horizon; return exact trace and certificate.

    Raises:
        TypeError: neither a scene nor the path of its file, its text or an item.
        SceneError, UnsupportedError, SimulationError: the scene can not be built, modelled or solved.
    """
    scene = scene_of(scene, "certify")
    return certify_mechanism(scene.mechanism, _times(scene, duration, samples))


def simulate(
    scene: SceneLike,
    duration: float | None = None,
    engine: str = RECORDED,
    samples: int = SAMPLES,
    *,
    truncate: bool = False,
) -> Trace:
    """Simulate a scene with one engine for `duration`, by default its horizon, and record it at equal intervals.

    With engine `both`, the trace is that of the exact engine, cut where the engines part. `truncate` cuts the trace
    where a sample stands out by 5σ, events included. The last state is at `stable_until`, the end of the description.
    If that is before a `duration` that was asked for, a MotionEndsWarning gives the reason.

    Raises:
        TypeError: neither a scene nor the path of its file, its text or an item.
        UnknownNameError: no such engine.
        SceneError, UnsupportedError, SimulationError: the scene can not be built, modelled or solved.
    """
    scene = scene_of(scene, "simulate")
    trace = whole(scene, duration, engine, samples)
    trace = truncated(trace) if truncate else trace
    if duration is not None and trace.stable_until < duration:
        unit = scene.units.time
        problem = f"the motion is described until {trace.stable_until:.6g} {unit}, not {duration:g} {unit}"
        warn(f"{problem}: {ending(trace)}; the record ends there", MotionEndsWarning, stacklevel=2)
    return trace.until(trace.stable_until)


def whole(scene: Scene, duration: float | None = None, engine: str = RECORDED, samples: int = SAMPLES) -> Trace:
    """Simulate a scene for the whole duration, as plots need; the states after `stable_until` mean nothing."""
    if engine == BOTH:
        return certify(scene, duration, samples)[0]
    return ENGINES[engine](scene.mechanism, _times(scene, duration, samples))


def _times(scene: Scene, duration: float | None, samples: int) -> Array:
    duration = scene.horizon if duration is None else duration
    if not (isfinite(duration) and duration > 0.0 and samples > 1):
        problem = f"{duration} {scene.units.time} in {samples} samples is no record"
        raise SceneError("duration", problem, "give a positive, finite duration and at least two samples")
    return np.linspace(0.0, duration, samples)
