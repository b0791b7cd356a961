"""Event functions of a contact mode, each zero at its event, with its rates and forces."""

from collections.abc import Callable, Iterator
from math import isfinite
from typing import NamedTuple, TypeVar

import numpy as np

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.forces import (
    UNLIMITED_FRICTION,
    ForceSolution,
    SwitchState,
    active_set,
    is_moderate,
    solve_regular,
    system,
)
from sim2reason.simulation.engines.mujoco.integration import Knot
from sim2reason.simulation.engines.mujoco.model import CompiledModel
from sim2reason.simulation.engines.mujoco.record import MotionRecord

T = TypeVar("T")

CONSTANT_RATE_RTOL = 1e-6  # fraction of the largest acceleration: constant ones differ by less

DISTANCES = frozenset({"gap", "reach", "border", "strain"})
"""The kinds of margins that can dip below zero and rise again within a step."""


class EventFunction(NamedTuple):
    """The kind, index and side of an event function, whose value is zero at the event."""

    kind: str
    number: int
    side: int


class ActingModel:
    """A model in one contact mode, with its rates, forces and event functions."""

    def __init__(self, model: CompiledModel, record: MotionRecord, switches: SwitchState, found: ForceSolution) -> None:
        """Store the model, which is at the start, and the forces there."""
        self.model, self.record, self.switches, self.mode, self._found = model, record, switches, found.mode, found
        self.constant = model.constant
        self.rate = self._constant_rate if self.constant else self._rate()
        self.unbound = not (found.mode.rows or found.mode.faces)  # nothing constrains it: no force is looked for
        one_sided = [number for number, row in enumerate(model.rows()) if not row.both]
        self._one_sided = [i for i in one_sided if not (self.constant and found.mode.rows[i])]
        self._loose = [number for number, stuck in enumerate(switches.stuck) if not stuck]
        self._limits = list(self._finite_limits())
        self.events: list[EventFunction] = [*self._of_rows(), *self._of_faces(), *self._of_positions()]
        if not self.constant:
            self.events += self._of_switches()
        self._places_of_distances = [place for place, event in enumerate(self.events) if event.kind in DISTANCES]

    # ---- the event functions

    def _of_rows(self) -> Iterator[EventFunction]:
        for number in self._one_sided:
            yield EventFunction("force" if self.mode.rows[number] else "spare", number, 0)

    def _of_faces(self) -> Iterator[EventFunction]:
        """Yield the event functions of faces; forces are none of them where all forces are constant."""
        for number, (face, side) in enumerate(zip(self.model.mechanism.faces, self.mode.rubbing, strict=True)):
            if not (face.guided or self.constant):
                yield EventFunction("normal", number, 0)
            if side:
                yield EventFunction("slip", number, side)
            elif 0.0 < face.static_friction < UNLIMITED_FRICTION and not self.constant:
                yield EventFunction("grip", number, 1)
                yield EventFunction("grip", number, -1)

    def _of_positions(self) -> Iterator[EventFunction]:
        yield from (EventFunction("gap", number, 0) for number in self._loose)
        yield from (EventFunction("reach", number, 0) for number in range(len(self.record.runs)))
        yield from (EventFunction("limit", number, side) for number, _, side, _ in self._limits)

    def _of_switches(self) -> Iterator[EventFunction]:
        switches = self.switches
        yield from (EventFunction("burn", number, 0) for number, burning in enumerate(switches.burning) if burning)
        yield from (EventFunction("strain", number, 0) for number in range(len(switches.strained)))
        for number, inside in enumerate(switches.inside):
            yield from (EventFunction("border", number, side) for side in range(len(inside)))

    def _finite_limits(self) -> Iterator[tuple[int, int, int, float]]:
        """Yield the finite limits of coordinates: number, joint, side and value."""
        for number, coordinate in enumerate(self.model.mechanism.coordinates):
            for side, limit in ((-1, coordinate.lower), (1, coordinate.upper)):
                if isfinite(limit):
                    yield number, self.model.index[coordinate.name], side, limit

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
            if np.abs(now - started).max(initial=0.0) > CONSTANT_RATE_RTOL * max(1.0, *map(abs, started.tolist())):
                raise SimulationError("MuJoCo: a force changes between two events")

    def _rate(self) -> Callable[[float, Array], Array]:
        """Return the function that computes the time derivative of (q, v)."""
        model, switches, mode, n = self.model, self.switches, self.mode, self.model.size
        acts = active_set(mode, model.faces.friction)
        free = not (acts.rows or acts.closed)

        def rate(time: float, values: Array) -> Array:
            q, v = values[:n], values[n:]
            model.set_state(time, q, v, switches)
            derivative: Array = np.empty(2 * n)
            derivative[:n], x = v, derivative[n:]
            if free:
                model.accelerate(model.loads(), x)
                if not is_moderate(x):
                    x[:] = self.forces().x
                return derivative
            conditions = [model.condition(number) for number in acts.rows]
            rows, targets = [gradient for gradient, _ in conditions], [target for _, target in conditions]
            if not acts.closed and not model.uneven:  # M⁻¹ of a nearly massless part would leave round-off
                found = model.constrained_acceleration(model.loads(), rows, targets)
            else:
                loads, gradients = model.loads(), np.array(rows)
                matrix, wanted = system(model.inertia(), loads, gradients, targets, model.faces, mode, acts)
                found = solve_regular(matrix, wanted)
            x[:] = found[:n] if found is not None else self.forces().x
            return derivative

        return rate

    def forces(self) -> ForceSolution:
        """Return all forces at the present state of the model."""
        return self.record.forces(self.mode)

    def knot(self, time: float, values: Array) -> tuple[Knot, list[float]]:
        """Return the record of the end of a step (time, state, rates), and the values of all event functions there."""
        n = self.model.size
        if self.constant or not self.unbound:  # otherwise `rate` sets the state
            self.model.set_state(time, values[:n], values[n:], self.switches)
        if self.constant or self.unbound:
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

    def margins(self) -> list[float]:
        """Return the values of all event functions at the present state of the model."""
        if not (self.constant or self.unbound):
            return self._margins(self.forces())
        if not self.constant:
            return [*self._positions(), *self._switches()]
        # under constant forces, each value is a polynomial of time of degree ≤ 4
        return [*(self.model.row(number).spare for number in self._one_sided), *self._slips(), *self._positions()]

    def _margins(self, forces: ForceSolution) -> list[float]:
        rows, pulls, acting = self.model.rows(), forces.rows.tolist(), self.mode.rows
        of_rows = [pulls[number] if acting[number] else rows[number].spare for number in self._one_sided]
        return [*of_rows, *self._faces(forces), *self._positions(), *self._switches()]

    def distances(self) -> list[float]:
        """Return the values of the event functions that are distances, which require no forces."""
        values = [*self._positions(), *self._switches()]
        before = len(self.events) - len(values)
        return [values[place - before] for place in self._places_of_distances]

    def distances_among(self, every: list[T]) -> list[T]:
        """Return what belongs to the event functions that are distances, from what belongs to all."""
        return [every[place] for place in self._places_of_distances]

    def _slips(self) -> list[float]:
        """Return the speeds of the faces that slip."""
        slips, v = self.model.faces.slips, self.model.v
        return [side * float(slips[number].dot(v)) for number, side in enumerate(self.mode.rubbing) if side]

    def _faces(self, forces: ForceSolution) -> Iterator[float]:
        model = self.model
        normals, frictions = forces.normal.tolist(), forces.friction.tolist()
        for number, face in enumerate(model.mechanism.faces):
            friction, normal = face.static_friction, normals[number]
            if not face.guided:
                yield normal
            side = self.mode.rubbing[number]
            if side:
                yield side * float(model.faces.slips[number].dot(model.v))
            elif 0.0 < friction < UNLIMITED_FRICTION:
                yield friction * abs(normal) + frictions[number]
                yield friction * abs(normal) - frictions[number]

    def _positions(self) -> list[float]:
        model, meetings = self.model, self.model.mechanism.meetings
        gap, q = model.square_gap if self.constant else model.gap, model.q.tolist()
        gaps = [gap(meetings[number]) for number in self._loose]
        reaches = self.record.run_lengths()
        return [*gaps, *reaches, *(limit - q[at] if side > 0 else q[at] - limit for _, at, side, limit in self._limits)]

    def _switches(self) -> list[float]:
        model, mechanism, switches = self.model, self.model.mechanism, self.switches
        burns = zip(mechanism.burns, switches.burning, strict=True)
        values = [burn.until - model.time for burn, burning in burns if burning]
        strains = zip(model.pulls.deformations(model.q), switches.strained, strict=True)
        values += [strain if strained else -strain for strain, strained in strains]
        for number, inside in enumerate(switches.inside):
            borders = zip(model.borders(number), inside, strict=True)
            values += [margin if within else -margin for margin, within in borders]
        return values
