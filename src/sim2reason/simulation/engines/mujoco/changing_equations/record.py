"""The recorded steps of a mechanism with changing equations, and interpolation between them."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise
from math import nan

import numpy as np
from numpy.typing import NDArray

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import Rigid
from sim2reason.scenes.dsl.state import Array, Dynamics, State
from sim2reason.simulation.engines.mujoco.changing_equations.forces import (
    ContactMode,
    ForceProblem,
    ForceSolution,
    Row,
    SwitchState,
    solve_mode,
)
from sim2reason.simulation.engines.mujoco.changing_equations.model import ConstrainedModel

Integers = NDArray[np.intp]

PASSING_DISTANCE = 1e-6  # m; ends of a line coincide if closer, if they may pass each other (unknown sign)
COINCIDENCE_DISTANCE = 1e-9  # m; ends of a line that are closer coincide


STEP_SIMILARITY = (
    0.1  # fraction of a step: neighbouring steps of a more different size are left out of the interpolation
)


@dataclass(frozen=True)
class Knot:
    """The end of a step: joint positions and velocities, and their time derivatives."""

    time: float
    values: Array  # (2·joints,)
    rates: Array


@dataclass
class ModeInterval:
    """An interval of one contact mode: its forces, and the recorded ends of steps (knots) in order of time."""

    way: ContactMode
    found: ForceSolution
    situation: SwitchState
    knots: list[Knot] = field(default_factory=list[Knot])


class Quintic:
    """The quintic Hermite interpolation of a step, from values, first and second derivatives at both ends."""

    def __init__(self, first: Knot, last: Knot) -> None:
        """Compute the coefficients of the interpolation."""
        n = len(first.values) // 2
        self._time, self._span = first.time, last.time - first.time
        h = self._span
        q0, v0, a0 = first.values[:n], first.values[n:] * h, first.rates[n:] * h * h
        q1, v1, a1 = last.values[:n], last.values[n:] * h, last.rates[n:] * h * h
        rise = q1 - q0
        self._c = (
            q0,
            v0,
            0.5 * a0,
            10.0 * rise - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1,
            -15.0 * rise + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1,
            6.0 * rise - 3.0 * (v0 + v1) - 0.5 * (a0 - a1),
        )
        self._start = first.values

    def at(self, time: float) -> tuple[Array, Array]:
        """Return positions and velocities at a time of the step, (joints,) each."""
        if self._span <= 0.0:
            n = len(self._start) // 2
            return self._start[:n], self._start[n:]
        x = (time - self._time) / self._span
        q0, v0, c, d, e, f = self._c
        q = q0 + x * (v0 + x * (c + x * (d + x * (e + x * f))))
        v = (v0 + x * (2.0 * c + x * (3.0 * d + x * (4.0 * e + 5.0 * x * f)))) / self._span
        return q, v


def interpolate_knots(knots: Sequence[Knot], times: Array) -> Array:
    """Return positions and velocities at times, (m, 2·joints), by Hermite interpolation between ends of steps."""
    n, origin = len(knots[0].values) // 2, knots[0].time
    h = knots[-1].time - origin
    if h <= 0.0:
        return np.repeat(knots[0].values[None, :], len(times), axis=0)
    powers: Array = np.arange(3.0 * len(knots))
    x = np.array([(knot.time - origin) / h for knot in knots])
    matrix = np.concatenate(_powers(x, powers))
    values, rates = np.array([knot.values for knot in knots]), np.array([knot.rates for knot in knots])
    shape = np.linalg.solve(matrix, np.concatenate([values[:, :n], values[:, n:] * h, rates[:, n:] * h * h]))
    places, slopes, _ = _powers((times - origin) / h, powers)
    return np.concatenate([places @ shape, (slopes @ shape) / h], axis=1)


def _beside(knots: Sequence[Knot], place: int) -> Sequence[Knot]:
    """Return the recorded ends of a step, and those of neighbouring steps if these are of similar size."""
    first, last = place, min(place + 1, len(knots) - 1)
    span = knots[last].time - knots[first].time
    for _ in range(2):
        before = first > 0 and _is_alike(knots[first].time - knots[first - 1].time, span)
        after = last + 1 < len(knots) and _is_alike(knots[last + 1].time - knots[last].time, span)
        if before and (first == place or not after):
            first -= 1
        elif after:
            last += 1
    return knots[first : last + 1]


def _is_alike(step: float, span: float) -> bool:
    return STEP_SIMILARITY * span < step < span / STEP_SIMILARITY


def _powers(x: Array, powers: Array) -> tuple[Array, Array, Array]:
    """Return all powers of numbers, with their first and second derivatives, (numbers, powers) each."""
    column = x[:, None]
    place = column**powers
    rate = powers * column ** np.maximum(powers - 1.0, 0.0)
    bend = powers * (powers - 1.0) * column ** np.maximum(powers - 2.0, 0.0)
    return place, rate, bend


class MotionRecord:
    """All recorded segments of a motion, in order of time."""

    def __init__(self, model: ConstrainedModel) -> None:
        """Start without segments."""
        self._model = model
        self.stretches: list[ModeInterval] = []
        self.runs = self._runs()
        self._ways = [model.ways.get(run) for run in self.runs]

    def _runs(self) -> list[tuple[str, str]]:
        """Return the ends of the straight line segments that may coincide."""
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

    def run_length(self, number: int) -> float:
        """Return the distance of the ends of a line segment, m; negative once they have passed through each other."""
        first, last = self.runs[number]
        apart, way = self._model.place(last) - self._model.place(first), self._ways[number]
        return float(
            np.linalg.norm(apart) - PASSING_DISTANCE if way is None else apart @ np.array(way) - COINCIDENCE_DISTANCE
        )

    def run_rate(self, number: int) -> float:
        """Return the rate of change of the distance of the ends of a line segment at present, m/s."""
        first, last = (self._model.site(name) for name in self.runs[number])
        apart, parting = last.place - first.place, last.velocity - first.velocity
        way, far = self._ways[number], float(np.linalg.norm(apart))
        if way is None and far == 0.0:
            return -float(np.linalg.norm(parting))
        return float((apart / far if way is None else np.array(way)) @ parting)

    @property
    def last(self) -> Knot:
        """Return the recorded end of the latest step."""
        return self.stretches[-1].knots[-1]

    def start(self, way: ContactMode, found: ForceSolution, situation: SwitchState) -> None:
        """Begin a segment in a contact mode."""
        self.stretches.append(ModeInterval(way, found, situation.copy()))

    def add(self, knot: Knot) -> None:
        """Append the end of a step."""
        self.stretches[-1].knots.append(knot)

    def state(self, times: Array) -> State:
        """Return the motion at `times`, s, with forces recomputed; after the end the last state is repeated."""
        model, mechanism = self._model, self._model.mechanism
        lines, names = [line.name for line in mechanism.constraints], list(mechanism.contacts)
        n, rows, faces = model.size, len(lines), len(mechanism.faces)
        motion, forces = np.zeros((len(times), 3 * n)), np.zeros((len(times), rows + 2 * faces))
        for stretch, numbers, values in self._joints(times):
            motion[numbers, : 2 * n] = values
            motion[numbers, 2 * n :], forces[numbers] = self._forces(stretch, times[numbers], values)
        q, v, a = (motion[:, first : first + n][:, model.coordinates] for first in (0, n, 2 * n))
        tension, normal, friction = np.split(forces.T, (rows, rows + faces))
        dynamics = Dynamics(
            a,
            dict(zip(lines, tension, strict=True)),
            dict(zip(names, normal, strict=True)),
            dict(zip(names, friction, strict=True)),
        )
        return State.of(mechanism, times, (q, v), dynamics)

    def _forces(self, stretch: ModeInterval, times: Array, values: Array) -> tuple[Array, Array]:
        """Return the accelerations (m, joints) and the forces of lines and faces at states (m, 2·joints) of a segment.

        Forces that the motion does not determine are NaN.
        """
        n, lines = self._model.size, len(self._model.mechanism.constraints)
        found = [stretch.found]
        if not self._model.constant:
            found.clear()
            for time, value in zip(times.tolist(), values, strict=True):
                self._model.stand(time, value[:n], value[n:], stretch.situation)
                found.append(self.forces(stretch.way))
        every = np.array([np.concatenate([each.rows, each.normal, each.friction]) for each in found])
        every[:, stretch.found.unknown > 0.0] = nan
        kept = np.r_[: lines, len(stretch.found.rows) : every.shape[1]]
        return np.array([each.x for each in found]), every[:, kept]

    def _joints(self, times: Array) -> Iterator[tuple[ModeInterval, Integers, Array]]:
        """Yield each recorded segment with the numbers of the times within its steps, and the joint values there."""
        starts = [stretch.knots[0].time for stretch in self.stretches]
        owners = np.maximum(np.searchsorted(starts, times, side="right") - 1, 0)
        for number, stretch in enumerate(self.stretches):
            mine = np.flatnonzero(owners == number)
            knots, ends = stretch.knots, [knot.time for knot in stretch.knots]
            places = np.clip(np.searchsorted(ends, times[mine], side="right") - 1, 0, max(len(knots) - 2, 0))
            for place in range(len(knots)):
                here = mine[places == place]
                if len(here):
                    yield stretch, here, interpolate_knots(_beside(knots, place), np.minimum(times[here], ends[-1]))

    def forces(self, way: ContactMode) -> ForceSolution:
        """Return the forces of a contact mode at the present state; raise SimulationError if they do not exist."""
        rows = self._model.rows()
        found = solve_mode(present_problem(self._model, rows, way.rubbing, (True,) * len(rows)), way)
        if found is None:
            raise SimulationError("MuJoCo: the constraints contradict each other")
        return found


def present_problem(
    model: ConstrainedModel, rows: list[Row], sliding: tuple[int, ...], allowed: tuple[bool, ...]
) -> ForceProblem:
    """Return the data for the forces at the present state of a model."""
    return ForceProblem(
        model.inertia().copy(),
        model.loads(),
        np.array([row.gradient for row in rows]).reshape(len(rows), model.size),
        np.array([row.target for row in rows]),
        tuple(row.both for row in rows),
        tuple(row.follows for row in rows),
        model.rises,
        model.slips,
        model.friction,
        np.array([face.static_friction for face in model.mechanism.faces]),
        sliding,
        tuple(face.guided for face in model.mechanism.faces),
        allowed,
        model.budget,
    )
