"""The recorded steps of a motion, and its states between them."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from math import nan, sqrt

import numpy as np
from numpy.typing import NDArray

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import Rigid
from sim2reason.scenes.dsl.state import Array, Dynamics, State
from sim2reason.simulation.engines.mujoco.forces import (
    ContactMode,
    ForceProblem,
    ForceSolution,
    Row,
    SwitchState,
    solve_mode,
)
from sim2reason.simulation.engines.mujoco.integration import Knot, interpolate_knots, neighbouring_knots
from sim2reason.simulation.engines.mujoco.model import CompiledModel

Integers = NDArray[np.intp]

PASSING_DISTANCE = 1e-6  # m; ends of a line coincide if closer, if they may pass each other (unknown sign)
COINCIDENCE_DISTANCE = 1e-9  # m; ends of a line that are closer coincide


@dataclass
class ModeInterval:
    """An interval of one contact mode: its forces, and the recorded ends of steps (knots) in order of time."""

    mode: ContactMode
    found: ForceSolution
    switches: SwitchState
    knots: list[Knot] = field(default_factory=list[Knot])


class MotionRecord:
    """All recorded segments of a motion, in order of time."""

    def __init__(self, model: CompiledModel) -> None:
        """Start without segments."""
        self._model = model
        self.intervals: list[ModeInterval] = []
        self.runs = self._runs()
        self._directions = [model.directions.get(run) for run in self.runs]

    def _runs(self) -> list[tuple[str, str]]:
        """Return the ends of the straight line segments that may coincide."""
        segments: dict[tuple[str, str], None] = {}
        for line in self._model.mechanism.lines:
            if not isinstance(line.law, Rigid):
                segments.update(dict.fromkeys(pairwise(line.through)))
        moving: list[tuple[str, str]] = []
        for first, last in segments:
            relative_jacobian = self._model.site(last).jacobian - self._model.site(first).jacobian
            if np.abs(relative_jacobian).max(initial=0.0) > 1e-9:
                moving.append((first, last))
        return moving

    def run_lengths(self) -> list[float]:
        """Return the distances of the ends of line segments, m; negative once they have passed through each other."""
        lengths: list[float] = []
        for (first, last), direction in zip(self._model.places(self.runs), self._directions, strict=True):
            x, y, z = last[0] - first[0], last[1] - first[1], last[2] - first[2]
            if direction is None:
                lengths.append(sqrt(x * x + y * y + z * z) - PASSING_DISTANCE)
            else:
                a, b, c = direction
                lengths.append(x * a + y * b + z * c - COINCIDENCE_DISTANCE)
        return lengths

    def run_rate(self, number: int) -> float:
        """Return the rate of change of the distance of the ends of a line segment at present, m/s."""
        first, last = (self._model.site(name) for name in self.runs[number])
        separation, parting = last.place - first.place, last.velocity - first.velocity
        direction, far = self._directions[number], sqrt(separation.dot(separation))
        if direction is None and far == 0.0:
            return -sqrt(parting.dot(parting))
        return float((separation / far if direction is None else np.array(direction)).dot(parting))

    @property
    def last(self) -> Knot:
        """Return the recorded end of the latest step."""
        return self.intervals[-1].knots[-1]

    def start(self, mode: ContactMode, found: ForceSolution, switches: SwitchState) -> None:
        """Begin a segment in a contact mode."""
        self.intervals.append(ModeInterval(mode, found, switches.copy()))

    def add(self, knot: Knot) -> None:
        """Append the end of a step."""
        self.intervals[-1].knots.append(knot)

    def state(self, times: Array) -> State:
        """Return the motion at `times`, s, with forces recomputed; after the end the last state is repeated."""
        model, mechanism = self._model, self._model.mechanism
        lines, names = [line.name for line in mechanism.constraints], list(mechanism.contacts)
        n, rows, faces = model.size, len(lines), len(mechanism.faces)
        motion, forces = np.zeros((len(times), 3 * n)), np.zeros((len(times), rows + 2 * faces))
        for interval, numbers, values in self._joints(times):
            motion[numbers, : 2 * n] = values
            motion[numbers, 2 * n :], forces[numbers] = self._forces(interval, times[numbers], values)
        q, v, a = (motion[:, first : first + n][:, model.coordinates] for first in (0, n, 2 * n))
        tension, normal, friction = np.split(forces.T, (rows, rows + faces))
        dynamics = Dynamics(
            a,
            dict(zip(lines, tension, strict=True)),
            dict(zip(names, normal, strict=True)),
            dict(zip(names, friction, strict=True)),
        )
        return State.of(mechanism, times, (q, v), dynamics)

    def _forces(self, interval: ModeInterval, times: Array, values: Array) -> tuple[Array, Array]:
        """Return the accelerations (m, joints) and the forces of lines and faces at states (m, 2·joints) of a segment.

        Forces that the motion does not determine are NaN.
        """
        lines, rows, found = len(self._model.mechanism.constraints), len(interval.found.rows), [interval.found]
        if not self._model.constant:
            found = [self._forces_at(interval, *at) for at in zip(times.tolist(), values, strict=True)]
        every = np.array([np.concatenate([each.rows[:lines], each.normal, each.friction]) for each in found])
        unknown = interval.found.unknown
        every[:, np.concatenate([unknown[:lines], unknown[rows:]]) > 0.0] = nan
        return np.array([each.x for each in found]), every

    def _forces_at(self, interval: ModeInterval, time: float, values: Array) -> ForceSolution:
        n = self._model.size
        self._model.set_state(time, values[:n], values[n:], interval.switches)
        return self.forces(interval.mode)

    def _joints(self, times: Array) -> Iterator[tuple[ModeInterval, Integers, Array]]:
        """Yield each recorded segment with the numbers of the times within its steps, and the joint values there."""
        starts = [interval.knots[0].time for interval in self.intervals]
        owners = np.maximum(np.searchsorted(starts, times, side="right") - 1, 0)
        for number, interval in enumerate(self.intervals):
            mine = np.flatnonzero(owners == number)
            knots, ends = interval.knots, [knot.time for knot in interval.knots]
            places = np.clip(np.searchsorted(ends, times[mine], side="right") - 1, 0, max(len(knots) - 2, 0))
            for index in range(len(knots)):
                here = mine[places == index]
                if len(here):
                    around, at = neighbouring_knots(knots, index), np.minimum(times[here], ends[-1])
                    yield interval, here, interpolate_knots(around, at)

    def forces(self, mode: ContactMode) -> ForceSolution:
        """Return the forces of a contact mode at the present state; raise SimulationError if they do not exist."""
        rows = self._model.rows()
        solution = solve_mode(present_problem(self._model, rows, mode.rubbing, (True,) * len(rows)), mode)
        if solution is None:
            raise SimulationError("MuJoCo: the constraints contradict each other")
        return solution


def present_problem(
    model: CompiledModel, rows: list[Row], sliding: tuple[int, ...], allowed: tuple[bool, ...]
) -> ForceProblem:
    """Return the data for the forces at the present state of a model."""
    return ForceProblem(
        model.inertia().copy(),
        model.loads(),
        np.array([row.gradient for row in rows]).reshape(len(rows), model.size),
        [row.target for row in rows],
        tuple([row.both for row in rows]),
        tuple([row.follows for row in rows]),
        model.faces,
        sliding,
        allowed,
        model.budget,
    )
