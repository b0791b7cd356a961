"""What is watched while one way of acting lasts: margins, positive until something happens."""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.simulation.engines.mujoco.changing_equations.forces import (
    LARGE,
    NEVER,
    Faces,
    Found,
    Way,
    acting,
    quick,
    system,
)
from sim2reason.simulation.engines.mujoco.changing_equations.model import HardModel
from sim2reason.simulation.engines.mujoco.changing_equations.record import HardRecord, Knot
from sim2reason.simulation.engines.mujoco.changing_equations.situation import Situation

DISTANCES = frozenset({"gap", "reach", "border", "strain"})
"""Margins that can dip below zero and rise again within a step."""


class Due(NamedTuple):
    """What is left until something happens, and what: kind, number, side."""

    kind: str
    number: int
    side: int
    value: float


class ActingModel:
    """A model in one way of acting: its rates, forces and margins."""

    def __init__(self, model: HardModel, record: HardRecord, situation: Situation, way: Way) -> None:
        """Nothing is computed before it is asked for."""
        self.model, self.record, self.situation, self.way = model, record, situation, way
        self.rate = self._rate()
        self._unbound = not (way.rows or way.faces)  # nothing constrains it: no force is looked for

    def _rate(self) -> Callable[[float, Array], Array]:
        """The rate of (q, v)."""
        model, situation, way, n = self.model, self.situation, self.way, self.model.size
        faces, acts = Faces(model.rises, model.slips, model.friction), acting(way, model.friction)
        free = not (acts.rows or acts.closed)

        def rate(time: float, values: Array) -> Array:
            model.stand(time, values[:n], values[n:], situation)
            if free:
                x = model.unheld(model.loads())
                return np.concatenate([values[n:], x if abs(x).max(initial=0.0) < LARGE else self.forces().x])
            rows = [model.row(number) for number in acts.rows]
            held, targets = [row.gradient for row in rows], [row.target for row in rows]
            if not acts.closed:
                x = model.held(model.loads(), np.array(held), np.array(targets))
                return np.concatenate([values[n:], x if x is not None else self.forces().x])
            matrix, wanted = system(model.inertia(), model.loads(), held, targets, faces, way, acts)
            found = quick(matrix, wanted)
            x = found[:n] if found is not None else self.forces().x
            return np.concatenate([values[n:], x])

        return rate

    def forces(self) -> Found:
        """All forces of the state at which the model stands."""
        return self.record.forces(self.way)

    def knot(self, time: float, values: Array) -> tuple[Knot, list[Due]]:
        """The end of a step, and all margins there."""
        n = self.model.size
        if self._unbound:
            return Knot(time, values, self.rate(time, values)), self.margins()
        self.model.stand(time, values[:n], values[n:], self.situation)
        forces = self.forces()
        return Knot(time, values, np.concatenate([values[n:], forces.x])), self._margins(forces)

    def closeness(self, knot: Knot) -> float:
        """By how much less than its tolerance a step from a knot may err, since two are close that attract each other.

        Where none attract each other, that is 1.
        """
        if not self.model.mechanism.attractions:
            return 1.0
        n = self.model.size
        self.model.stand(knot.time, knot.values[:n], knot.values[n:], self.situation)
        return self.model.closeness()

    def margins(self) -> list[Due]:
        """All margins of the state at which the model stands."""
        return [*self._places(), *self._switches()] if self._unbound else self._margins(self.forces())

    def _margins(self, forces: Found) -> list[Due]:
        return [*self._rows(forces), *self._faces(forces), *self._places(), *self._switches()]

    def distances(self) -> list[Due]:
        """Those of the margins that are distances, which need no forces."""
        return [due for due in [*self._places(), *self._switches()] if due.kind in DISTANCES]

    def _rows(self, forces: Found) -> Iterator[Due]:
        for number, row in enumerate(self.model.rows()):
            if not row.both:
                acts = self.way.rows[number]
                yield Due("force" if acts else "spare", number, 0, float(forces.rows[number]) if acts else row.spare)

    def _faces(self, forces: Found) -> Iterator[Due]:
        model = self.model
        for number, face in enumerate(model.mechanism.faces):
            friction, normal = face.static_friction, float(forces.normal[number])
            if not face.guided:
                yield Due("normal", number, 0, normal)
            side = self.way.rubbing[number]
            if side:
                yield Due("slip", number, side, side * float(model.slips[number] @ model.v))
            elif 0.0 < friction < NEVER:
                held = float(forces.friction[number])
                yield Due("grip", number, 1, friction * abs(normal) + held)
                yield Due("grip", number, -1, friction * abs(normal) - held)

    def _places(self) -> Iterator[Due]:
        model, mechanism = self.model, self.model.mechanism
        for number, meeting in enumerate(mechanism.meetings):
            if not self.situation.stuck[number]:
                yield Due("gap", number, 0, model.separation(meeting)[0])
        for number in range(len(self.record.runs)):
            yield Due("reach", number, 0, self.record.run_length(number))
        q = model.q[model.coordinates]
        for number, coordinate in enumerate(mechanism.coordinates):
            for side, room in ((-1, q[number] - coordinate.lower), (1, coordinate.upper - q[number])):
                if np.isfinite(room):
                    yield Due("limit", number, side, float(room))

    def _switches(self) -> Iterator[Due]:
        model, mechanism = self.model, self.model.mechanism
        for number, burning in enumerate(self.situation.burning):
            if burning:
                yield Due("burn", number, 0, mechanism.burns[number].until - model.time)
        for number, strained in enumerate(self.situation.strained):
            strain = model.strain(number)[0]
            yield Due("strain", number, 0, strain if strained else -strain)
        for number in range(len(mechanism.forces)):
            for side, margin in enumerate(model.borders(number)):
                yield Due("border", number, side, margin if self.situation.inside[number][side] else -margin)
