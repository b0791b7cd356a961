"""Simulation and certification of scenes."""

from math import isfinite
from warnings import warn

import numpy as np

from sim2reason.errors import MotionEndsWarning, SceneError
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.files import SceneLike, scene_of
from sim2reason.simulation.certify import RECORDED, Certificate
from sim2reason.simulation.certify import certify as certify_mechanism
from sim2reason.simulation.trace import ENGINES, Trace, ending
from sim2reason.simulation.truncate import truncate as truncated

SAMPLES = 101
BOTH = "both"
"""Engine name for the trace of the exact engine, checked by the other."""


def certify(scene: SceneLike, duration: float | None = None, samples: int = SAMPLES) -> tuple[Trace, Certificate]:
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
    scene = scene_of(scene, "simulate")
    trace = simulate_full_duration(scene, duration, engine, samples)
    trace = truncated(trace) if truncate else trace
    if duration is not None and trace.stable_until < duration:
        unit = scene.units.time
        problem = f"the motion is described until {trace.stable_until:.6g} {unit}, not {duration:g} {unit}"
        warn(f"{problem}: {ending(trace)}; the record ends there", MotionEndsWarning, stacklevel=2)
    return trace.until(trace.stable_until)


def simulate_full_duration(
    scene: Scene, duration: float | None = None, engine: str = RECORDED, samples: int = SAMPLES
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
