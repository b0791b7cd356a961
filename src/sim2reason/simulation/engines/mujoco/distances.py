"""Distances between points of bodies, as arrays: lengths of lines, tensions of springs, and attraction."""

from collections.abc import Mapping
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np

from sim2reason.base.records import record
from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import ZERO, Attraction, Line
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.vectors import Triple
from sim2reason.simulation.engines.mujoco.specification import mujoco

MIN_CLOSENESS = 1e-4  # smallest closeness; below, round-off dominates the step error


@record()
class PointMotion:
    """A point: its position, velocity, acceleration at q̈ = 0, and Jacobian (3, joints)."""

    place: Array
    velocity: Array
    bias: Array
    jacobian: Array


def distance(one: PointMotion, other: PointMotion) -> tuple[float, float, Array, float]:
    """Return the distance of two points, its rate, gradient and second derivative at q̈ = 0."""
    apart, parting = other.place - one.place, other.velocity - one.velocity
    length = float(np.linalg.norm(apart))
    if length == 0.0:
        raise SimulationError("two points of a line have come together")
    direction = apart / length
    rate = float(direction @ parting)
    bend = float(direction @ (other.bias - one.bias)) + (float(parting @ parting) - rate * rate) / length
    return length, rate, direction @ (other.jacobian - one.jacobian), bend


class Segments(NamedTuple):
    """The straight segments of lines: ends, lengths, directions, and Jacobians of separation (segments, 3, joints)."""

    places: Array  # positions of all sites
    runs: Array
    directions: Array
    moved: Array


class Lengths(NamedTuple):
    """The lengths of lines, m, with gradients (lines, joints) and straight segments."""

    values: Array
    gradients: Array
    segments: Segments


class Lines:
    """A set of lines, as arrays over their straight segments."""

    def __init__(
        self,
        lines: tuple[Line, ...],
        sites: dict[str, int],
        index: dict[str, int],
        model: Any,  # noqa: ANN401 - MuJoCo's
        *,
        straight: bool,
        directions: Mapping[tuple[str, str], Triple],
    ) -> None:
        """Index the sites and joints of the compiled `model`; `straight` means that no joint rotates.

        `directions` are the unit vectors of segments of constant direction. If the ends of such a segment nearly
        coincide, a direction computed from their positions would be round-off and would cause a jerk of the force.
        """
        self.lines = lines
        names = sorted({name for line in lines for name in line.through})
        place = {name: number for number, name in enumerate(names)}
        segments = [(owner, ends) for owner, line in enumerate(lines) for ends in pairwise(line.through)]
        self._model, self._straight = model, straight
        self._sites = np.array([sites[name] for name in names], dtype=np.intp)
        self._carriers = [int(model.site_bodyid[site]) for site in self._sites]
        self._first = np.array([place[first] for _, (first, _) in segments], dtype=np.intp)
        self._last = np.array([place[last] for _, (_, last) in segments], dtype=np.intp)
        self._kept = np.array([directions.get(ends, ZERO) for _, ends in segments]).reshape(len(segments), 3)
        self._keeps = np.array([ends in directions for _, ends in segments], dtype=bool)
        self._is_kept = bool(self._keeps.any())
        self._owned, self._wound = np.zeros((len(lines), len(segments))), np.zeros((len(lines), int(model.nv)))
        for number, (owner, _) in enumerate(segments):
            self._owned[owner, number] = 1.0
        for owner, line in enumerate(lines):
            for wheel in line.wheels:
                self._wound[owner, index[wheel.coordinate]] += wheel.radius
        self._wheels, self._single = bool(self._wound.any()), len(segments) == len(lines)
        self._apart: Array | None = None  # how the Jacobians of the ends of each piece differ, where nothing turns
        self._jacobians = np.zeros((len(names), 3, int(model.nv)))
        self._dots = np.zeros_like(self._jacobians)

    def lengths(self, data: Any, q: Array) -> Lengths:  # noqa: ANN401 - MuJoCo's
        """Return the lengths of the lines, with gradients and segments."""
        places = data.site_xpos.take(self._sites, axis=0)
        separations = places.take(self._last, axis=0) - places.take(self._first, axis=0)
        runs, directions = self._directions_of(separations)
        moved = self._jacobians_apart(data, places)
        values, gradients = self._sum_segments(runs), self._sum_segments(np.vecmat(directions, moved))
        if self._wheels:
            values, gradients = values + self._wound @ q, gradients + self._wound
        return Lengths(values, gradients, Segments(places, runs, directions, moved))

    def _directions_of(self, apart: Array) -> tuple[Array, Array]:
        """Return the lengths (segments,) and directions of segments, from the separations (segments, 3) of ends."""
        keeps = self._keeps
        runs: Array = np.sqrt(np.vecdot(apart, apart))
        if not (runs.all() or (runs.astype(bool) | keeps).all()):
            raise SimulationError("two points of a line have come together")
        if not self._is_kept:
            return runs, apart / runs[:, None]
        turning = apart / np.where(keeps, 1.0, runs)[:, None]
        return np.where(keeps, np.vecdot(apart, self._kept), runs), np.where(keeps[:, None], self._kept, turning)

    def bends(self, data: Any, v: Array, segments: Segments) -> Array:  # noqa: ANN401 - MuJoCo's
        """Return the second derivatives of the lengths at q̈ = 0, m/s²."""
        places, runs, directions, moved = segments
        parting = moved @ v
        along = np.vecdot(directions, parting)
        turning = (np.vecdot(parting, parting) - along * along) / np.where(self._keeps, 1.0, runs)
        second_derivatives = np.where(self._keeps, 0.0, turning)
        if not self._straight:
            for number, carrier in enumerate(self._carriers):
                if carrier:
                    mujoco.mj_jacDot(self._model, data, self._dots[number], None, places[number], carrier)
            biases = self._dots @ v
            second_derivatives += np.vecdot(
                directions, biases.take(self._last, axis=0) - biases.take(self._first, axis=0)
            )
        return self._sum_segments(second_derivatives)

    def _sum_segments(self, parts: Array) -> Array:
        """Return, for each line, the sum of the values of its segments."""
        return parts if self._single else self._owned @ parts

    def _jacobians_apart(self, data: Any, places: Array) -> Array:  # noqa: ANN401 - MuJoCo's
        """Return the Jacobian of the separation of each segment's ends, (segments, 3, joints)."""
        if self._apart is not None:
            return self._apart
        for number, carrier in enumerate(self._carriers):
            if carrier:
                mujoco.mj_jac(self._model, data, self._jacobians[number], None, places[number], carrier)
        moved = self._jacobians.take(self._last, axis=0) - self._jacobians.take(self._first, axis=0)
        self._apart = moved if self._straight else None
        return moved


class Pulls:
    """The lines whose tension is a function of length and rate: springs and prescribed pulls."""

    def __init__(self, lines: Lines) -> None:
        """Store the force laws as arrays."""
        self._lines = lines
        laws = [line.law for line in lines.lines]
        self._given, self._stiffness, self._natural, self._damping = (
            np.array([getattr(law, name, 0.0) for law in laws]) for name in ("force", "stiffness", "length", "damping")
        )
        self._damps = bool(self._damping.any())

    def load(self, data: Any, q: Array, v: Array, idle: list[Line]) -> Array:  # noqa: ANN401 - MuJoCo's
        """Return the load on the joints, (joints,), of all lines except `idle` ones."""
        values, gradients, _ = self._lines.lengths(data, q)
        tension = self._given + self._stiffness * (values - self._natural)
        if self._damps:
            tension += self._damping * (gradients @ v)
        if idle:
            tension *= [line not in idle for line in self._lines.lines]
        return np.asarray(-tension @ gradients, dtype=np.float64)


class Attractions:
    """All attracting pairs of bodies, as arrays."""

    def __init__(
        self,
        pairs: tuple[Attraction, ...],
        bodies: dict[str, int],
        model: Any,  # noqa: ANN401 - MuJoCo's
        *,
        straight: bool,
    ) -> None:
        """Index the pairs by `bodies` in the compiled `model`; `straight` means that no joint rotates."""
        self._pairs, self._model, self._straight = pairs, model, straight
        self._first = np.array([bodies[pair.a] for pair in pairs], dtype=np.intp)
        self._last = np.array([bodies[pair.b] for pair in pairs], dtype=np.intp)
        self._constants = np.array([pair.constant for pair in pairs])
        self._exponents = np.array([-0.5 * (pair.power + 1.0) for pair in pairs])
        self._bodies = sorted({*self._first.tolist(), *self._last.tolist()})
        self._jacobians = np.zeros((int(model.nbody), 3, int(model.nv)))
        self._apart: Array | None = None  # how the Jacobians of each pair differ, where nothing turns
        self._began = self._at_the_start() if pairs else np.zeros(0)

    def closeness(self, data: Any) -> float:  # noqa: ANN401 - MuJoCo's
        """Return the smallest ratio of a pair's present to initial distance, at most 1, to scale the step tolerance.

        When two bodies pass closely, a small error of their positions is a large part of their distance, which
        determines their deflection.
        """
        squares = self._squares(data)[1]
        return max(MIN_CLOSENESS, min(1.0, float(np.sqrt((squares / self._began).min()))))

    def _at_the_start(self) -> Array:
        """Return the squared distances of the pairs at the start, (pairs,), m²."""
        data = mujoco.MjData(self._model)
        mujoco.mj_fwdPosition(self._model, data)
        return self._squares(data)[1]

    def _squares(self, data: Any) -> tuple[Array, Array]:  # noqa: ANN401 - MuJoCo's
        """Return the separation of the centres of mass of each pair, (pairs, 3), m, and its square, (pairs,), m²."""
        places = data.xipos
        separations: Array = places.take(self._last, axis=0) - places.take(self._first, axis=0)
        return separations, np.vecdot(separations, separations)

    def load(self, data: Any) -> Array:  # noqa: ANN401 - MuJoCo's
        """Return the load on the joints, (joints,): constant·m·m′/rᵖ between centres of mass, for present masses."""
        separations, squares = self._squares(data)
        if not squares.all():
            pair = self._pairs[int(squares.argmin())]
            raise SimulationError(f"{pair.a} and {pair.b} are at one place")
        masses = self._model.body_mass
        pulls = self._constants * masses[self._first] * masses[self._last] * squares**self._exponents
        return (pulls[:, None] * separations).ravel() @ self._jacobians_apart(data)

    def _jacobians_apart(self, data: Any) -> Array:  # noqa: ANN401 - MuJoCo's
        """Return the derivatives of the vector between the centres of mass of each pair, (3·pairs, joints)."""
        if self._apart is not None:
            return self._apart
        for body in self._bodies:
            mujoco.mj_jacBodyCom(self._model, data, self._jacobians[body], None, body)
        moved = (self._jacobians[self._first] - self._jacobians[self._last]).reshape(-1, self._jacobians.shape[2])
        self._apart = moved if self._straight else None
        return moved
