"""A place of rest with its forces: whether it can be one, and how it looks to whoever reads it."""

import math

import numpy as np

from sim2reason.dsl.state import Dynamics, State
from sim2reason.lazy import cached_property
from sim2reason.simulation.rest.loads import LITTLE, RestingLoads, Vector, shared


class Balance:
    """Forces in balance at some coordinates."""

    def __init__(self, loads: RestingLoads, places: Vector, active: list[int], forces: Vector) -> None:
        """`forces` are those of all rows, of which the `active` ones act."""
        self.loads, self.places, self.active, self.forces = loads, places, active, forces
        self.system, self.assembly = loads.system, loads.assembly(places)
        self.rows = self.assembly.rows(self.system.starts)

    @cached_property
    def normal(self) -> list[float]:
        """The normal force on each face, N: N = Σλ J_z − F_z."""
        normal = [-float(press) for press in self.assembly.press]
        for row, force in zip(self.rows, self.forces.tolist(), strict=False):
            for contact, part in row.lift.items():
                normal[contact] += force * float(part)
        return normal

    def holds(self, little: float) -> bool:
        """Whether faces push, nothing is tighter than it may be, nothing overlaps, and nothing has passed a pulley.

        Forces up to `little`, N, are none.
        """
        system, q = self.system, self.places
        slack = all(float(row.value) >= -LITTLE for i, row in enumerate(self.rows) if i not in self.active)
        pushed = all(force >= -little for i, force in enumerate(self.normal) if i not in system.guided)
        apart = all(float(self.assembly.separation(pair).gap) > LITTLE for pair in system.mechanism.meetings)
        within = all(limit.room + limit.sign * float(q[limit.coordinate]) > LITTLE for limit in system.limits)
        return slack and pushed and apart and within and self._strained() and self._ahead()

    def _strained(self) -> bool:
        """Whether springs that act only one way act here as they did at the start."""
        for (line, law), strained in zip(self.system.mechanism.half_springs, self.system.phase.strained, strict=True):
            strain = law.side * float(self.assembly.length(line).value - law.length)
            if (strain > LITTLE) != strained or abs(strain) <= LITTLE:
                return False
        return True

    def _ahead(self) -> bool:
        """Whether no straight piece of a line has turned right round, as one whose end has passed a pulley has."""
        for ends, run in self.system.runs.items():
            way = self.assembly.frames.distance(*ends).way
            if sum(float(a) * float(b) for a, b in zip(way, run.way, strict=True)) < LITTLE - 1.0:
                return False
        return True

    def state(self) -> State:
        """One instant of it; forces that others could bear are NaN, and all normal forces with them."""
        mechanism, kinds, still = self.system.mechanism, self.loads.kinds, np.zeros((1, self.loads.size))
        known = self.forces.copy()
        open_ = shared(self.loads.at(self.places).along[self.active])
        known[self.active] = np.where(open_, math.nan, self.forces[self.active])
        friction = {grip.contact: -float(known[len(kinds) + i]) for i, grip in enumerate(self.loads.slips)}
        names = [face.subject for face in mechanism.faces]
        dynamics = Dynamics(
            still,
            {kind.name: known[i : i + 1] for i, kind in enumerate(kinds) if kind.name in mechanism.line},
            {
                name: np.array([math.nan if open_.any() else force])
                for name, force in zip(names, self.normal, strict=True)
            },
            {name: np.array([friction.get(number, 0.0)]) for number, name in enumerate(names)},
        )
        return State.of(mechanism, np.zeros(1), (self.places[None, :], still), dynamics)
