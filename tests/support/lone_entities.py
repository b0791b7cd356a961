"""Scenes of one entity, and samples of their motion."""

from collections.abc import Mapping

import numpy as np

from sim2reason.scenes.dsl.entity import ENTITIES, Entity, Named
from sim2reason.scenes.dsl.model import Choice, draw
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.trace import Trace


def alone(entity: Entity) -> Scene:
    """Return a scene with only the given entity."""
    return Scene(entities=(Named(name="it", entity=entity),))


def drawn(name: str, seed: int, choices: Mapping[str, Choice] | None = None) -> Scene:
    """Return a scene with one random entity of a class."""
    return alone(draw(ENTITIES[name], np.random.default_rng(seed), choices or {}))


def followed(entity: Entity, until: float, count: int = 201) -> Trace:
    """Return the motion of a lone entity by the exact engine, at evenly spaced times."""
    return simulate(alone(entity).mechanism, np.linspace(0.0, until, count))


def close(found: object, wanted: object, scale: float = 0.0) -> None:
    """Assert that values agree to 1e-8 of the larger of the greatest of them and `scale`."""
    a, b = np.asarray(found, dtype=float), np.asarray(wanted, dtype=float)
    size = max(float(np.abs(b).max()), scale)
    assert float(np.abs(a - b).max()) <= 1e-8 * size, f"{a} instead of {b}"


def planar(trace: Trace) -> tuple[Array, Array, Array, Array]:
    """Return the first two coordinates of a motion and their rates, (n,) each."""
    return trace.state.q[:, 0], trace.state.q[:, 1], trace.state.v[:, 0], trace.state.v[:, 1]


def happened(trace: Trace, *kinds: str) -> list[tuple[str, float]]:
    """Return the events of the given kinds, by default all but turning points, with their times in s."""
    return [(e.kind, e.time) for e in trace.events if (e.kind in kinds if kinds else e.changes_motion)]
