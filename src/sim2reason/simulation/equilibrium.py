"""Equilibria of a mechanism with their forces, searched from its initial state."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.errors import UnsupportedError
from sim2reason.scenes.dsl.fields import Magnetic, Push
from sim2reason.scenes.dsl.mechanism import Inextensible, Mechanism
from sim2reason.scenes.dsl.state import Dynamics, State
from sim2reason.scenes.dsl.structure import changing
from sim2reason.simulation.loads import (
    EQUILIBRIUM_TOL,
    ZERO_FORCE_TOL,
    Loads,
    RestingLoads,
    Vector,
    null_space,
    symmetric,
    undetermined_forces,
)


class Balance:
    """The balance of forces of a mechanism at given coordinates."""

    def __init__(self, loads: RestingLoads, places: Vector, active: list[int], forces: Vector) -> None:
        """Store the coordinates (`places`) and the `forces` of all rows, of which the `active` ones act."""
        self.loads, self.places, self.active, self.forces = loads, places, active, forces
        self.system, self.assembly = loads.system, loads.assembly(places)
        self.rows = self.assembly.rows(self.system.starts)

    @cached_property
    def normal(self) -> list[float]:
        """Return the normal force on each face, N, from N = Σλ J_z − F_z."""
        normal = [-float(press) for press in self.assembly.press]
        for row, force in zip(self.rows, self.forces.tolist(), strict=False):
            for contact, part in row.lift.items():
                normal[contact] += force * float(part)
        return normal

    def holds(self, little: float) -> bool:
        """Return whether all contact, length and collision conditions hold at these coordinates.

        Forces up to `little`, N, count as zero.
        """
        system, q = self.system, self.places
        slack = all(float(row.value) >= -ZERO_FORCE_TOL for i, row in enumerate(self.rows) if i not in self.active)
        pushed = all(force >= -little for i, force in enumerate(self.normal) if i not in system.guided)
        separated = all(
            float(self.assembly.separation(pair).gap) > ZERO_FORCE_TOL for pair in system.mechanism.meetings
        )
        within = all(
            limit.initial_travel + limit.sign * float(q[limit.coordinate]) > ZERO_FORCE_TOL for limit in system.limits
        )
        return slack and pushed and separated and within and self._strained() and self._ahead()

    def _strained(self) -> bool:
        """Return whether one-sided springs are in the same state here as at the start."""
        for (line, law), strained in zip(self.system.mechanism.half_springs, self.system.phase.strained, strict=True):
            strain = law.side * float(self.assembly.length(line).value - law.length)
            if (strain > ZERO_FORCE_TOL) != strained or abs(strain) <= ZERO_FORCE_TOL:
                return False
        return True

    def _ahead(self) -> bool:
        """Return whether no straight line segment has reversed its direction, as after its end passes a pulley."""
        for ends, run in self.system.runs.items():
            direction = self.assembly.frames.distance(*ends).direction
            if sum(float(a) * float(b) for a, b in zip(direction, run.direction, strict=True)) < ZERO_FORCE_TOL - 1.0:
                return False
        return True

    def state(self) -> State:
        """Return the state at rest; undetermined forces are NaN, and if there are any, so are all normal forces."""
        mechanism, kinds, still = self.system.mechanism, self.loads.kinds, np.zeros((1, self.loads.size))
        known = self.forces.copy()
        open_ = undetermined_forces(self.loads.at(self.places).along[self.active])
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


MAX_STEPS = 40  # largest number of steps of the search
FORCE_DECAY_STEPS = 6  # steps after which a force without restoring stiffness must have vanished
ZERO_STIFFNESS_RTOL = 1e-6  # fraction of the largest stiffness: a smaller one counts as zero
MAX_STEP = 0.5  # largest step: rad, or as a fraction of the longest line
START_COUNT = 32  # starting points of the search for other equilibria; few miss a basin of a tenth of the range
COLLISION_FREE_RANGE = 0.2  # rad, and fraction of the shortest line: a motion within that avoids collisions
EQUILIBRIUM_DISTANCE_TOL = 1e-5  # m or rad, of the largest stiffness: equilibria closer than that are equal
CACHE_SIZE = 8  # number of cached results


@dataclass(frozen=True)
class Equilibrium:
    """A stable equilibrium of a mechanism."""

    state: State  # one instant at rest; forces shared by several rows are NaN
    allowed: Vector  # (n, m), orthonormal columns: the motions that the constraints allow
    stiffness: Vector  # (m, m), in these directions, N/m or N m/rad
    free: int  # number of motions without restoring force
    active: tuple[int, ...]  # the acting rows, those of contacts that never slip last

    @property
    def mechanism(self) -> Mechanism:
        """Return the mechanism at rest."""
        return self.state.mechanism

    @cached_property
    def linear(self) -> bool:
        """Return whether loads are linear in the coordinates, within the range without collisions."""
        return _Descent(RestingLoads(self.mechanism), self.coordinates).linear()

    @property
    def coordinates(self) -> Vector:
        """Return the coordinates relative to the initial state, m or rad, (n,)."""
        return self.state.q[0]


@lru_cache(maxsize=CACHE_SIZE)
def equilibrium(mechanism: Mechanism) -> Equilibrium | None:
    """Return the stable equilibrium nearest to the initial state; None if there is none or it is not isolated.

    There is none for mechanisms with friction, with time-dependent forces, engines, winches or feet, and without forces
    that depend on position.
    """
    if not _restores(mechanism):
        return None
    try:
        return _Descent(RestingLoads(mechanism)).find_rest()
    except (UnsupportedError, ZeroDivisionError, np.linalg.LinAlgError):
        return None


@lru_cache(maxsize=CACHE_SIZE)
def unique_equilibrium(mechanism: Mechanism) -> Equilibrium | None:
    """Return the only stable equilibrium; None if a search from other positions finds a different one."""
    rest = equilibrium(mechanism)
    if rest is None or rest.linear:
        return rest
    descent = _Descent(RestingLoads(mechanism), rest.coordinates)
    ends = (descent.end(point, rest.active) for point in descent.points())
    return rest if all(end is None or _same(rest, end, descent.loads) for end in ends) else None


def neighbour(rest: Equilibrium, shift: Vector) -> Vector:
    """Return the coordinates (n,) of an admissible position near an equilibrium, displaced by `shift` (n,)."""
    loads, places = RestingLoads(rest.mechanism), rest.coordinates + shift
    for _ in range(3):
        places = places + loads.tightening(loads.at(places), list(rest.active))
    return places


def steady(mechanism: Mechanism) -> bool:
    """Return whether no force depends on time: no time-dependent field, no engine, no winch."""
    fields = all(force.law.profile.steady for force in mechanism.forces if isinstance(force.law, Push | Magnetic))
    strings = (line.law for line in mechanism.lines if isinstance(line.law, Inextensible))
    return fields and not mechanism.burns and not any(law.reel for law in strings)


def _restores(mechanism: Mechanism) -> bool:
    """Return whether an isolated equilibrium is possible and permanent."""
    rubs = any(0.0 < face.friction < math.inf for face in mechanism.faces)
    bounded = any(force.region is not None for force in mechanism.forces)
    other = rubs or bounded or mechanism.attractions or mechanism.feet
    return steady(mechanism) and not other and changing(mechanism) != ""


def _same(one: Equilibrium, other: Equilibrium, loads: RestingLoads) -> bool:
    """Return whether two equilibria are equal up to whole turns and motions without restoring force."""
    difference = one.coordinates - other.coordinates
    difference = np.where(loads.hinges, np.remainder(difference + math.pi, 2.0 * math.pi) - math.pi, difference)
    rolled = [number for grip in loads.slips for number, _ in grip.slip.terms if not loads.hinges[number]]
    difference[rolled] = 0.0  # what never slips is as far on as it has turned
    if float(np.abs(difference).max()) <= EQUILIBRIUM_DISTANCE_TOL:
        return True
    if not one.free or one.free != other.free:
        return False
    mine, others = np.linalg.eigvalsh(one.stiffness), np.linalg.eigvalsh(other.stiffness)
    return bool(
        np.allclose(mine, others, rtol=EQUILIBRIUM_DISTANCE_TOL, atol=EQUILIBRIUM_DISTANCE_TOL * float(mine[-1]))
    )


def _spread(size: int) -> Vector:
    """Return evenly spread points between −1 and 1, (STARTS, size), by powers of the root of x^(size + 1) = x + 1."""
    root = 2.0
    for _ in range(30):
        root = (1.0 + root) ** (1.0 / (1 + size))
    steps = root ** -np.arange(1.0, size + 1.0)
    return 2.0 * np.remainder(0.5 + np.outer(np.arange(1, START_COUNT + 1), steps), 1.0) - 1.0


class _Descent:
    """The search for an equilibrium by descent of the potential energy."""

    def __init__(self, loads: RestingLoads, places: Vector | None = None) -> None:
        """Initialize with the force scale at `places`, by default at the start."""
        self.loads, self.size = loads, loads.size
        lengths = [length for length in loads.system.starts.values() if length > ZERO_FORCE_TOL] or [1.0]
        self.shortest, self.longest = min(lengths), max(lengths)
        self.scale = loads.largest(np.zeros(self.size) if places is None else places)

    def find_rest(self) -> Equilibrium | None:
        """Return the equilibrium reached from the start; strings that would have to push are released on the way."""
        places, both = np.zeros(self.size), self.loads.both
        spare = self.loads.at(places).spare
        active = [number for number, always in enumerate(both) if always or spare[number] <= ZERO_FORCE_TOL]
        for _ in range(1 + len(both)):
            settled = self._settled(places, active)
            if settled is None:
                return None
            places, forces = settled
            pushing = [
                number for number in active if not both[number] and forces[number] < -ZERO_FORCE_TOL * self.scale
            ]
            if not pushing:
                return self._checked(places, active, forces)
            active = [number for number in active if number not in pushing]
        return None

    def end(self, point: Vector, active: tuple[int, ...]) -> Equilibrium | None:
        """Return the equilibrium reached from a point with the same active rows; None if the search fails."""
        try:
            settled = self._settled(point, list(active))
            return None if settled is None else self._checked(settled[0], list(active), settled[1])
        except (ZeroDivisionError, np.linalg.LinAlgError):
            return None

    def points(self) -> Iterator[Vector]:
        """Yield starting coordinates for the search, spread over the range and the same on each call."""
        points = _spread(self.size)
        yield from points * np.where(self.loads.hinges, math.pi, self.longest)

    def linear(self) -> bool:
        """Return whether loads are linear in the coordinates, within the range without collisions."""
        near = np.where(self.loads.hinges, COLLISION_FREE_RANGE, COLLISION_FREE_RANGE * self.shortest)
        return self.loads.linear(_spread(self.size)[:2] * near, self.scale)

    def _settled(self, places: Vector, active: list[int]) -> tuple[Vector, Vector] | None:
        """Return the coordinates and the forces of all rows at equilibrium; None if the search does not converge."""
        driven = 0
        most = MAX_STEP * np.where(self.loads.hinges, 1.0, self.longest)
        for _ in range(MAX_STEPS):
            loads = self.loads.at(places)
            free = null_space(loads.along[active], self.size)
            forces = self.loads.forces(loads, active)
            down = free.T @ loads.force
            if self._balanced(loads, down, active):
                return places, forces
            tight = self.loads.tightening(loads, active)
            stiffness = free.T @ self.loads.stiffness(places, forces, active)
            sizes, axes = np.linalg.eigh(symmetric(stiffness @ free))
            along = axes.T @ (down - stiffness @ tight)
            firm = np.abs(sizes) > ZERO_STIFFNESS_RTOL * np.abs(sizes).max(initial=0.0)
            pushed = ~firm & (np.abs(along) > ZERO_FORCE_TOL * self.scale)
            driven = driven + 1 if pushed.any() else 0
            if driven > FORCE_DECAY_STEPS:
                return None
            part = np.where(firm, along / np.where(firm, np.abs(sizes), 1.0), np.where(pushed, np.sign(along), 0.0))
            step = tight + free @ (axes @ part)
            share = min(1.0, float((most / np.maximum(np.abs(step), 1e-300)).min()))
            if share < 1.0 and self._is_rest(places + step, active):  # far away, but the loads are linear
                share = 1.0
            places = places + share * step
        return None

    def _balanced(self, loads: Loads, down: Vector, active: list[int]) -> bool:
        """Return whether no force remains along the allowed motions, and all active constraints are satisfied."""
        lacking = float(np.abs(loads.spare[active]).max(initial=0.0))
        return max(float(np.abs(down).max(initial=0.0)) / self.scale, lacking) <= EQUILIBRIUM_TOL

    def _is_rest(self, places: Vector, active: list[int]) -> bool:
        loads = self.loads.at(places)
        return self._balanced(loads, null_space(loads.along[active], self.size).T @ loads.force, active)

    def _checked(self, places: Vector, active: list[int], forces: Vector) -> Equilibrium | None:
        """Return the equilibrium if all conditions hold and it is stable; else None."""
        free = null_space(self.loads.at(places).along[active], self.size)
        stiffness = symmetric(free.T @ self.loads.stiffness(places, forces, active) @ free)
        sizes = np.linalg.eigvalsh(stiffness)
        threshold = ZERO_STIFFNESS_RTOL * float(np.abs(sizes).max(initial=0.0))
        if not len(sizes) or float(sizes.max()) <= 0.0 or float(sizes.min()) < -threshold:
            return None
        balance = Balance(self.loads, places, active, forces)
        if not balance.holds(ZERO_FORCE_TOL * self.scale):
            return None
        return Equilibrium(balance.state(), free, stiffness, int((sizes <= threshold).sum()), tuple(active))
