"""What the steps of a changing mechanism leave behind, and the motion at any time between them."""

from dataclasses import dataclass, field
from itertools import pairwise
from math import nan

import numpy as np

from sim2reason.dsl.mechanism import Inextensible, Prop, Rigid
from sim2reason.dsl.state import Array, State, with_given_tensions
from sim2reason.errors import SimulationError
from sim2reason.simulation.engines.mujoco.hard_model import HardModel, Row, Situation
from sim2reason.simulation.engines.mujoco.hard_modes import Found, Instant, Way, solved


@dataclass(frozen=True)
class Knot:
    """The end of a step: joint positions and rates, and their rates."""

    time: float
    values: Array  # (2·joints,)
    rates: Array


@dataclass
class Stretch:
    """The knots of one way of acting."""

    way: Way
    found: Found
    situation: Situation
    knots: list[Knot] = field(default_factory=list[Knot])


def between(first: Knot, last: Knot, times: Array) -> Array:
    """Positions and rates at times of a step: Hermite's quintic through both ends, (m, 2·joints)."""
    n = len(first.values) // 2
    h = last.time - first.time
    if h <= 0.0:
        return np.repeat(first.values[None, :], len(times), axis=0)
    x = ((times - first.time) / h)[:, None]
    q0, v0, a0 = first.values[:n], first.values[n:] * h, first.rates[n:] * h * h
    q1, v1, a1 = last.values[:n], last.values[n:] * h, last.rates[n:] * h * h
    rise, c = q1 - q0, 0.5 * a0
    d = 10.0 * rise - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1
    e = -15.0 * rise + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1
    f = 6.0 * rise - 3.0 * (v0 + v1) - 0.5 * (a0 - a1)
    q = q0 + x * (v0 + x * (c + x * (d + x * (e + x * f))))
    v = (v0 + x * (2.0 * c + x * (3.0 * d + x * (4.0 * e + 5.0 * x * f)))) / h
    return np.concatenate([q, v], axis=1)


class HardRecord:
    """All stretches of a motion, in order of time."""

    def __init__(self, model: HardModel) -> None:
        """Nothing has moved yet."""
        self._model = model
        self.stretches: list[Stretch] = []
        self.runs = self._runs()

    def _runs(self) -> list[tuple[str, str]]:
        """The straight pieces of lines whose ends may come together."""
        found: dict[tuple[str, str], None] = {}
        for line in self._model.mechanism.lines:
            if not isinstance(line.law, Rigid):
                found.update(dict.fromkeys(pairwise(line.through)))
        moving: list[tuple[str, str]] = []
        for first, last in found:
            apart = self._model.site(last).jacobian - self._model.site(first).jacobian
            if np.abs(apart).max(initial=0.0) > 1e-9:
                moving.append((first, last))
        return moving

    @property
    def last(self) -> Knot:
        """The latest knot."""
        return self.stretches[-1].knots[-1]

    def start(self, way: Way, found: Found, situation: Situation) -> None:
        """Begin a stretch."""
        now = Situation([list(each) for each in situation.inside], list(situation.burning), list(situation.stuck))
        self.stretches.append(Stretch(way, found, now))

    def add(self, knot: Knot) -> None:
        """Note the end of a step."""
        self.stretches[-1].knots.append(knot)

    def state(self, times: Array) -> State:
        """The motion at `times`, s; forces are found anew there. After the end the last knot stays."""
        model, mechanism = self._model, self._model.mechanism
        lines = [line.name for line in mechanism.lines if isinstance(line.law, Inextensible | Rigid | Prop)]
        n, m = model.size, len(times)
        q, v, a = (np.zeros((m, len(model.coordinates))) for _ in range(3))
        tension, normal = np.zeros((len(lines), m)), np.zeros((len(mechanism.faces), m))
        friction = np.zeros_like(normal)
        for number, time in enumerate(times):
            stretch, values = self._at(float(time))
            model.stand(float(time), values[:n], values[n:], stretch.situation)
            found = self.forces(stretch.way)
            q[number], v[number] = values[:n][model.coordinates], values[n:][model.coordinates]
            a[number] = found.x[model.coordinates]
            unknown, rows, faces = stretch.found.unknown, len(found.rows), len(mechanism.faces)
            tension[:, number] = np.where(unknown[: len(lines)] > 0.0, nan, found.rows[: len(lines)])
            normal[:, number] = np.where(unknown[rows : rows + faces] > 0.0, nan, found.normal)
            friction[:, number] = np.where(unknown[rows + faces :] > 0.0, nan, found.friction)
        names = list(mechanism.contacts)
        state = State(
            mechanism,
            times,
            q,
            v,
            a,
            dict(zip(lines, tension, strict=True)),
            dict(zip(names, normal, strict=True)),
            dict(zip(names, friction, strict=True)),
        )
        return with_given_tensions(state)

    def _at(self, time: float) -> tuple[Stretch, Array]:
        """The stretch that a time belongs to, and the joints then."""
        stretch = self.stretches[0]
        for each in self.stretches:
            if each.knots[0].time <= time:
                stretch = each
        knots = stretch.knots
        place = int(np.searchsorted([knot.time for knot in knots], time, side="right")) - 1
        first = knots[max(place, 0)]
        last = knots[min(max(place, 0) + 1, len(knots) - 1)]
        return stretch, between(first, last, np.array([min(time, last.time)]))[0]

    def forces(self, way: Way) -> Found:
        """The forces of one way at the state at which the model stands; SimulationError if they don't exist."""
        rows = self._model.rows()
        found = solved(at_present(self._model, rows, way.rubbing, (True,) * len(rows)), way)
        if found is None:
            raise SimulationError("MuJoCo: the constraints contradict each other")
        return found


def at_present(model: HardModel, rows: list[Row], sliding: tuple[int, ...], allowed: tuple[bool, ...]) -> Instant:
    """The numbers of the state at which a model stands."""
    return Instant(
        model.inertia().copy(),
        model.loads(),
        np.array([row.gradient for row in rows]).reshape(len(rows), model.size),
        np.array([row.target for row in rows]),
        tuple(row.both for row in rows),
        tuple(row.follows for row in rows),
        model.rises,
        model.slips,
        model.friction,
        sliding,
        tuple(face.guided for face in model.mechanism.faces),
        allowed,
    )
