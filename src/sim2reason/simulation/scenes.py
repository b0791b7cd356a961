"""Simulating and certifying scenes rather than mechanisms."""

from math import isfinite

import numpy as np

from sim2reason.dsl.scene import Scene
from sim2reason.dsl.state import Array
from sim2reason.errors import SceneError
from sim2reason.simulation.certify import RECORDED, Certificate
from sim2reason.simulation.certify import certify as certify_mechanism
from sim2reason.simulation.trace import ENGINES, Trace

DURATION = 2.0  # s
SAMPLES = 101


def certify(scene: Scene, duration: float = DURATION, samples: int = SAMPLES) -> tuple[Trace, Certificate]:
    """Simulate a scene for `duration` seconds by both engines and compare: the exact trace and its certificate.

    Raises:
        SceneError, UnsupportedError, SimulationError: the scene can not be built, modelled or solved.
    """
    return certify_mechanism(scene.mechanism, _times(duration, samples))


def simulate(scene: Scene, duration: float = DURATION, engine: str = RECORDED, samples: int = SAMPLES) -> Trace:
    """Simulate a scene for `duration` seconds by one engine, recorded at equal intervals.

    Raises:
        UnknownNameError: no such engine.
        SceneError, UnsupportedError, SimulationError: the scene can not be built, modelled or solved.
    """
    return ENGINES[engine](scene.mechanism, _times(duration, samples))


def _times(duration: float, samples: int) -> Array:
    if not (isfinite(duration) and duration > 0.0 and samples > 1):
        problem = f"{duration} s in {samples} samples is no record"
        raise SceneError("duration", problem, "give a positive, finite duration and at least two samples")
    return np.linspace(0.0, duration, samples)
