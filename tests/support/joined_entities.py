"""Scenes of an entity whose ports are joined to others, by hand or at random, and their motion."""

from collections.abc import Mapping

import numpy as np

from sim2reason.scenes.connections.string import String
from sim2reason.scenes.connections.two_ended import Pivot
from sim2reason.scenes.dsl.connection import Connection, Link
from sim2reason.scenes.dsl.entity import ENTITIES, Entity, Named, outer_ports
from sim2reason.scenes.dsl.model import Choice, draw
from sim2reason.scenes.dsl.ports import Base, Mount, Pass, Port
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.trace import Trace

CLOSERS = {
    "ConstantForcePuller": "end",
    "ConstantVelocityPuller": "end",
    "MassWithFixedPulley": "tail",
    "MassWithMovablePulley": "top",
}
HOLDERS = {"FixedSupport": "end", "MassWithFixedPulley": "tail", "MassWithMovablePulley": "top"}
CHOICES: Mapping[str, Choice] = {
    "mass?": 0.3,
    "speed?": 0.3,
    "top?": 0.4,
    "top_friction?": 1.0,
    "left?": 0.5,
    "load?": 1.0,
}


def scene(entities: Mapping[str, Entity], *connections: Connection) -> Scene:
    """Return a scene of named entities."""
    named = tuple(Named(name=name, entity=entity) for name, entity in entities.items())
    return Scene(entities=named, connections=connections)


def string(*ports: str) -> String:
    """Return a string through ports written as in a file: ``string("stack.upper_right", "load.tail")``."""
    return String(links=tuple(_link(port) for port in ports))


def pivot(mount: str, base: str) -> Pivot:
    """Return a pivot from which the second entity hangs on the first."""
    return Pivot(links=(_link(mount), _link(base)))


def _link(port: str) -> Link:
    entity, _, name = port.partition(".")
    return Link(entity=entity, port=name)


class Followed:
    """Motion of a scene by the exact engine, with access by the names of coordinates and lines."""

    def __init__(self, made: Scene, until: float, count: int = 101) -> None:
        """Simulate the scene at evenly spaced times from 0 to `until` in s."""
        self.times: Array = np.linspace(0.0, until, count)
        self.trace: Trace = simulate(made.mechanism, self.times)
        self._number = made.mechanism.number

    def q(self, name: str) -> Array:
        """Return a coordinate in m or rad."""
        return self.trace.state.q[:, self._number[name]]

    def v(self, name: str) -> Array:
        """Return the first time derivative of a coordinate."""
        return self.trace.state.v[:, self._number[name]]

    def a(self, name: str) -> Array:
        """Return the second time derivative of a coordinate."""
        return self.trace.state.a[:, self._number[name]]

    def tension(self, name: str) -> Array:
        """Return the tension of a line in N."""
        return self.trace.state.tension[name]

    def events(self, *kinds: str) -> list[tuple[str, tuple[str, ...], float]]:
        """Return the events of the given kinds, by default all but turning points."""
        wanted = [e for e in self.trace.events if (e.kind in kinds if kinds else e.changes_motion)]
        return [(e.kind, e.subjects, e.time) for e in wanted]


def close(found: object, wanted: object, scale: float = 0.0) -> None:
    """Assert that values agree to 1e-8 of the larger of the greatest of them and `scale`."""
    a, b = np.asarray(found, dtype=float), np.asarray(wanted, dtype=float)
    size = max(float(np.abs(b).max()), scale)
    assert float(np.abs(a - b).max()) <= 1e-8 * size, f"{a} instead of {b}"


def at_random(kind: str, seed: int) -> Scene:
    """Return a scene with an entity of a class whose ports are joined at random to others that fit."""
    return _Composition(kind, np.random.default_rng([7, seed])).made()


class _Composition:
    def __init__(self, kind: str, rng: np.random.Generator) -> None:
        self.rng = rng
        self.entities: dict[str, Entity] = {"it": draw(ENTITIES[kind], rng, CHOICES)}
        self.connections: list[Connection] = []

    def made(self) -> Scene:
        for name, port in outer_ports(type(self.entities["it"])).items():
            part, _, side = name.rpartition("_")
            absent = side in ("left", "right") and getattr(self.entities["it"], part, self) is None
            if not absent and (port.required or self.rng.random() < 0.4):
                self._join(name, port)
        return scene(self.entities, *self.connections)

    def _join(self, name: str, port: Port) -> None:
        here = f"it.{name}"
        if isinstance(port, Pass):
            self.connections.append(string(self._closer(HOLDERS), here, self._closer(CLOSERS)))
        elif isinstance(port, Mount):
            self.connections.append(pivot(here, self._closer({"LightRodPendulum": "base"})))
        elif isinstance(port, Base):
            self.connections.append(pivot(self._closer({"SliderMass": "pivot"}), here))
        else:
            self.connections.append(string(here, self._closer(CLOSERS)))

    def _closer(self, closers: Mapping[str, str]) -> str:
        kind = sorted(closers)[int(self.rng.integers(len(closers)))]
        name = f"e{len(self.entities)}"
        self.entities[name] = draw(ENTITIES[kind], self.rng, CHOICES)
        return f"{name}.{closers[kind]}"
