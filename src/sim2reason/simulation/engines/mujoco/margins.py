"""Event functions of a contact mode, each zero at its event, with its rates and forces."""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.forces import (
    MAX_ACCELERATION,
    UNLIMITED_FRICTION,
    Faces,
    ForceSolution,
    SwitchState,
    active_set,
    solve_regular,
    system,
)
from sim2reason.simulation.engines.mujoco.integration import Knot
from sim2reason.simulation.engines.mujoco.model import CompiledModel
from sim2reason.simulation.engines.mujoco.record import MotionRecord

CONSTANT_RATE_RTOL = 1e-6  # fraction of the largest acceleration: constant ones differ by less

DISTANCES = frozenset({"gap", "reach", "border", "strain"})
"""The kinds of margins that can dip below zero and rise again within a step."""


class EventMargin(NamedTuple):
    """The value of an event function, which is zero at the event, with its kind, index and side."""

    kind: str
    number: int
    side: int
    value: float


class ActingModel:
    """A model in one contact mode, with its rates, forces and event functions."""

    def __init__(self, model: CompiledModel, record: MotionRecord, switches: SwitchState, found: ForceSolution) -> None:
        """Store the model, which is at the start, and the forces there."""
        self.model, self.record, self.switches, self.mode, self._found = model, record, switches, found.mode, found
        self.constant = model.constant
        self.rate = self._constant_rate if self.constant else self._rate()
        self._unbound = not (found.mode.rows or found.mode.faces)  # nothing constrains it: no force is looked for
        rows = model.rows() if self.constant else []
        self._idle = [i for i, row in enumerate(rows) if not (row.both or found.mode.rows[i])]

    def _constant_rate(self, time: float, values: Array) -> Array:
        """Return the time derivative of (q, v) where the accelerations are those at the start."""
        del time
        return np.concatenate([values[self.model.size :], self._found.x])

    def check(self, knot: Knot) -> None:
        """Raise SimulationError if accelerations that are constant by the structure have changed at a later state."""
        if self.constant:
            n = self.model.size
            self.model.set_state(knot.time, knot.values[:n], knot.values[n:], self.switches)
            now, started = self.forces().x, self._found.x
            if np.abs(now - started).max(initial=0.0) > CONSTANT_RATE_RTOL * max(
                1.0, float(np.abs(started).max(initial=0.0))
            ):
                raise SimulationError("MuJoCo: a force changes between two events")

    def _rate(self) -> Callable[[float, Array], Array]:
        """Return the function that computes the time derivative of (q, v)."""
        model, switches, mode, n = self.model, self.switches, self.mode, self.model.size
        faces, acts = Faces(model.rises, model.slips, model.friction), active_set(mode, model.friction)
        free = not (acts.rows or acts.closed)

        def rate(time: float, values: Array) -> Array:
            model.set_state(time, values[:n], values[n:], switches)
            if free:
                x = model.free_acceleration(model.loads())
                return np.concatenate(
                    [values[n:], x if abs(x).max(initial=0.0) < MAX_ACCELERATION else self.forces().x]
                )
            rows = [model.row(number) for number in acts.rows]
            row_gradients, targets = [row.gradient for row in rows], [row.target for row in rows]
            if not acts.closed and not model.uneven:  # M⁻¹ of a nearly massless part would leave round-off
                x = model.constrained_acceleration(model.loads(), np.array(row_gradients), np.array(targets))
                return np.concatenate([values[n:], x if x is not None else self.forces().x])
            matrix, wanted = system(model.inertia(), model.loads(), row_gradients, targets, faces, mode, acts)
            solution = solve_regular(matrix, wanted)
            x = solution[:n] if solution is not None else self.forces().x
            return np.concatenate([values[n:], x])

        return rate

    def forces(self) -> ForceSolution:
        """Return all forces at the present state of the model."""
        return self.record.forces(self.mode)

    def knot(self, time: float, values: Array) -> tuple[Knot, list[EventMargin]]:
        """Return the record of the end of a step (time, state, rates), and all event functions there."""
        n = self.model.size
        if self.constant or not self._unbound:  # otherwise `rate` sets the state
            self.model.set_state(time, values[:n], values[n:], self.switches)
        if self.constant or self._unbound:
            return Knot(time, values, self.rate(time, values)), self.margins()
        forces = self.forces()
        return Knot(time, values, np.concatenate([values[n:], forces.x])), self._margins(forces)

    def closeness(self, knot: Knot) -> float:
        """Return the factor by which a step tolerance shrinks because attracting bodies are close to each other.

        Without attraction the factor is 1.
        """
        if not self.model.mechanism.attractions:
            return 1.0
        n = self.model.size
        self.model.set_state(knot.time, knot.values[:n], knot.values[n:], self.switches)
        return self.model.closeness()

    def margins(self) -> list[EventMargin]:
        """Return all event functions at the present state of the model."""
        if self.constant:
            return [*self._varying()]
        return [*self._positions(), *self._switches()] if self._unbound else self._margins(self.forces())

    def _varying(self) -> Iterator[EventMargin]:
        """Yield the event functions that vary under constant forces, each a polynomial of time of degree ≤ 4."""
        for number in self._idle:
            yield EventMargin("spare", number, 0, self.model.row(number).spare)
        for number, side in enumerate(self.mode.rubbing):
            if side:
                yield EventMargin("slip", number, side, side * float(self.model.slips[number] @ self.model.v))
        yield from self._positions()

    def _margins(self, forces: ForceSolution) -> list[EventMargin]:
        return [*self._rows(forces), *self._faces(forces), *self._positions(), *self._switches()]

    def distances(self) -> list[EventMargin]:
        """Return the event functions that are distances, which require no forces."""
        return [due for due in [*self._positions(), *self._switches()] if due.kind in DISTANCES]

    def _rows(self, forces: ForceSolution) -> Iterator[EventMargin]:
        for number, row in enumerate(self.model.rows()):
            if not row.both:
                acts = self.mode.rows[number]
                yield EventMargin(
                    "force" if acts else "spare", number, 0, float(forces.rows[number]) if acts else row.spare
                )

    def _faces(self, forces: ForceSolution) -> Iterator[EventMargin]:
        model = self.model
        for number, face in enumerate(model.mechanism.faces):
            friction, normal = face.static_friction, float(forces.normal[number])
            if not face.guided:
                yield EventMargin("normal", number, 0, normal)
            side = self.mode.rubbing[number]
            if side:
                yield EventMargin("slip", number, side, side * float(model.slips[number] @ model.v))
            elif 0.0 < friction < UNLIMITED_FRICTION:
                friction_force = float(forces.friction[number])
                yield EventMargin("grip", number, 1, friction * abs(normal) + friction_force)
                yield EventMargin("grip", number, -1, friction * abs(normal) - friction_force)

    def _positions(self) -> Iterator[EventMargin]:
        model, mechanism = self.model, self.model.mechanism
        for number, meeting in enumerate(mechanism.meetings):
            if not self.switches.stuck[number]:
                gap = model.square_gap(meeting) if self.constant else model.separation(meeting)[0]
                yield EventMargin("gap", number, 0, gap)
        for number in range(len(self.record.runs)):
            yield EventMargin("reach", number, 0, self.record.run_length(number))
        q = model.q[model.coordinates]
        for number, coordinate in enumerate(mechanism.coordinates):
            for side, room in ((-1, q[number] - coordinate.lower), (1, coordinate.upper - q[number])):
                if np.isfinite(room):
                    yield EventMargin("limit", number, side, float(room))

    def _switches(self) -> Iterator[EventMargin]:
        model, mechanism = self.model, self.model.mechanism
        for number, burning in enumerate(self.switches.burning):
            if burning:
                yield EventMargin("burn", number, 0, mechanism.burns[number].until - model.time)
        for number, strained in enumerate(self.switches.strained):
            strain = model.strain(number)[0]
            yield EventMargin("strain", number, 0, strain if strained else -strain)
        for number in range(len(mechanism.forces)):
            for side, margin in enumerate(model.borders(number)):
                yield EventMargin("border", number, side, margin if self.switches.inside[number][side] else -margin)
