"""Distances between points of bodies, as arrays: lengths of lines, tensions of springs, and attraction."""

from collections.abc import Mapping
from itertools import pairwise
from math import sqrt
from typing import Any, NamedTuple

import numpy as np

from sim2reason.base.records import record
from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.mechanism import Attraction, Elastic, Line
from sim2reason.scenes.dsl.state import Array
from sim2reason.scenes.dsl.vectors import Vector
from sim2reason.simulation.engines.mujoco.specification import mujoco

MIN_CLOSENESS = 1e-4  # smallest closeness; below, round-off dominates the step error


@record()
class PointMotion:
    """A point: its position, velocity and Jacobian (3, joints), valid until the next state is set."""

    place: Array
    velocity: Array
    jacobian: Array


def separated(apart: Array) -> float:
    """Return the length of a vector between two points; raise SimulationError if they coincide."""
    length = sqrt(apart.dot(apart))
    if length == 0.0:
        raise SimulationError("two points of a line have come together")
    return length


def distance(one: PointMotion, other: PointMotion, bias: Array) -> tuple[float, float, Array, float]:
    """Return the distance of two points, its rate, gradient and second derivative at q̈ = 0.

    `bias` is their relative acceleration at q̈ = 0.
    """
    apart, parting = other.place - one.place, other.velocity - one.velocity
    length = separated(apart)
    direction = apart / length
    rate = float(direction.dot(parting))
    bend = float(direction.dot(bias)) + (float(parting.dot(parting)) - rate * rate) / length
    return length, rate, direction @ (other.jacobian - one.jacobian), bend


class Segments(NamedTuple):
    """The straight segments of lines: lengths, directions, and Jacobians of separation (3, joints)."""

    runs: list[float]
    directions: list[Vector]
    moved: list[Array]


class Lengths(NamedTuple):
    """The lengths of lines, m, with gradients (lines, joints) and straight segments."""

    values: list[float]
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
        data: Any,  # noqa: ANN401 - MuJoCo's
        *,
        straight: bool,
        directions: Mapping[tuple[str, str], Vector],
    ) -> None:
        """Index the sites and joints of the compiled `model`, whose state is `data`.

        `straight` means that no joint rotates.

        `directions` are the unit vectors of segments of constant direction. If the ends of such a segment nearly
        coincide, a direction computed from their positions would be round-off and would cause a jerk of the force.
        """
        self.lines = lines
        names = sorted({name for line in lines for name in line.through})
        place = {name: number for number, name in enumerate(names)}
        segments = [(owner, ends) for owner, line in enumerate(lines) for ends in pairwise(line.through)]
        self._model, self._data, self._straight, self._joints = model, data, straight, int(model.nv)
        self._moving = [
            (number, data.site_xpos[sites[name]], int(model.site_bodyid[sites[name]]))
            for number, name in enumerate(names)
            if model.site_bodyid[sites[name]]
        ]  # the sites of bodies: number, position (a view) and body
        self._first = [place[first] for _, (first, _) in segments]
        self._last = [place[last] for _, (_, last) in segments]
        self._ends = [(sites[first], sites[last], directions.get((first, last))) for _, (first, last) in segments]
        self._owned, self._wound = np.zeros((len(lines), len(segments))), np.zeros((len(lines), self._joints))
        for number, (owner, _) in enumerate(segments):
            self._owned[owner, number] = 1.0
        for owner, line in enumerate(lines):
            for wheel in line.wheels:
                self._wound[owner, index[wheel.coordinate]] += wheel.radius
        self._wheels, self._single = bool(self._wound.any()), len(segments) == len(lines)
        self._steady = straight and None not in [kept for *_, kept in self._ends]
        self._gradients: Array | None = None  # where they never change, since all is steady
        self._apart: list[Array] = []  # how the Jacobians of the ends of each segment differ
        self._columns: list[list[list[float]]] = []  # their columns
        self._jacobians = np.zeros((len(names), 3, self._joints))
        self._dots = np.zeros_like(self._jacobians)

    def values(self, q: Array) -> list[float]:
        """Return the lengths of the lines, m."""
        return self._lengths(self._measure()[0], q)

    def _lengths(self, runs: list[float], q: Array) -> list[float]:
        if self._single and not self._wheels:
            return runs
        values = self._sum_segments(np.array(runs))
        return (values + self._wound @ q if self._wheels else values).tolist()

    def lengths(self, q: Array) -> Lengths:
        """Return the lengths of the lines, with gradients and segments."""
        runs, directions = self._measure()
        gradients = self._gradients
        if gradients is None:
            gradients = self._differentiate(directions)
            self._gradients = gradients if self._steady else None
        return Lengths(self._lengths(runs, q), gradients, Segments(runs, directions, self._apart))

    def _differentiate(self, directions: list[Vector]) -> Array:
        """Return the gradients of the lengths, (lines, joints)."""
        self._differ()
        parts = [
            [0.0 + x * a + y * b + z * c for a, b, c in columns]  # without negative zeros, as in a sum
            for (x, y, z), columns in zip(directions, self._columns, strict=True)
        ]
        gradients = self._sum_segments(np.array(parts).reshape(len(parts), self._joints))
        return gradients + self._wound if self._wheels else gradients

    def _measure(self) -> tuple[list[float], list[Vector]]:
        """Return the lengths and directions of the segments; floats, since few numbers take numpy longer."""
        places = self._data.site_xpos.tolist()
        runs: list[float] = []
        directions: list[Vector] = []
        for first, last, kept in self._ends:
            (ax, ay, az), (bx, by, bz) = places[first], places[last]
            x, y, z = bx - ax, by - ay, bz - az
            if kept is None:
                run = sqrt(x * x + y * y + z * z)
                if run == 0.0:
                    raise SimulationError("two points of a line have come together")
                direction = (x / run, y / run, z / run)
            else:
                run, direction = x * kept[0] + y * kept[1] + z * kept[2], kept
            runs.append(run)
            directions.append(direction)
        return runs, directions

    def bends(self, v: Array, segments: Segments) -> list[float]:
        """Return the second derivatives of the lengths at q̈ = 0, m/s²."""
        if self._steady:
            return [0.0] * len(self.lines)
        runs, directions, moved = segments
        second_derivatives = [
            _turning(jacobian.dot(v).tolist(), direction, run) if kept is None else 0.0
            for (*_, kept), jacobian, direction, run in zip(self._ends, moved, directions, runs, strict=True)
        ]
        if not self._straight:
            for number, place, carrier in self._moving:
                mujoco.mj_jacDot(self._model, self._data, self._dots[number], None, place, carrier)
            biases = [dot.dot(v).tolist() for dot in self._dots]
            for number, (first, last, (a, b, c)) in enumerate(zip(self._first, self._last, directions, strict=True)):
                (x, y, z), (along, across, up) = biases[first], biases[last]
                second_derivatives[number] += a * (along - x) + b * (across - y) + c * (up - z)
        return self._sum_segments(np.array(second_derivatives)).tolist()

    def _sum_segments(self, parts: Array) -> Array:
        """Return, for each line, the sum of the values of its segments."""
        return parts if self._single else self._owned @ parts

    def _differ(self) -> None:
        """Compute the Jacobian of the separation of each segment's ends."""
        if self._straight and self._apart:
            return
        for number, place, carrier in self._moving:
            mujoco.mj_jac(self._model, self._data, self._jacobians[number], None, place, carrier)
        ends = zip(self._first, self._last, strict=True)
        self._apart = [np.subtract(self._jacobians[last], self._jacobians[first]) for first, last in ends]
        self._columns = [jacobian.T.tolist() for jacobian in self._apart]


def _turning(parting: list[float], direction: Vector, run: float) -> float:
    """Return the part of the second derivative of a length by which the velocity turns the segment."""
    (x, y, z), (a, b, c) = parting, direction
    along = a * x + b * y + c * z
    return (x * x + y * y + z * z - along * along) / run


class Pulls:
    """The lines whose tension is a function of length and rate: springs, some one-sided, and prescribed pulls."""

    def __init__(self, lines: Lines, half_springs: tuple[tuple[Line, Elastic], ...]) -> None:
        """Store the force laws as numbers."""
        self._lines = lines
        self._halves = [(lines.lines.index(line), law) for line, law in half_springs]
        laws, names = [line.law for line in lines.lines], ("force", "stiffness", "length")
        self._laws = [tuple(float(getattr(law, name, 0.0)) for name in names) for law in laws]
        self._damping = np.array([getattr(law, "damping", 0.0) for law in laws])
        self._damps = bool(self._damping.any())

    def load(self, q: Array, v: Array, idle: list[Line]) -> Array:
        """Return the load on the joints, (joints,), of all lines except `idle` ones."""
        values, gradients, _ = self._lines.lengths(q)
        laws = zip(self._laws, values, strict=True)
        push: Array = np.array(
            [-(given + stiffness * (value - natural)) for (given, stiffness, natural), value in laws]
        )
        if self._damps:
            push -= self._damping * gradients.dot(v)
        if idle:
            push *= [line not in idle for line in self._lines.lines]
        load: Array = push.dot(gradients)
        load += 0.0  # no negative zero
        return load

    def deformations(self, q: Array) -> list[float]:
        """Return the active deformations of the one-sided springs, m."""
        if not self._halves:
            return []
        values = self._lines.values(q)
        return [law.side * (values[place] - law.length) for place, law in self._halves]

    def deformation_rates(self, q: Array, v: Array) -> list[float]:
        """Return the rates of the active deformations of the one-sided springs, m/s."""
        if not self._halves:
            return []
        gradients = self._lines.lengths(q).gradients
        return [law.side * float(gradients[place].dot(v)) for place, law in self._halves]


class Attractions:
    """All attracting pairs of bodies, as arrays."""

    def __init__(
        self,
        pairs: tuple[Attraction, ...],
        bodies: dict[str, int],
        model: Any,  # noqa: ANN401 - MuJoCo's
        data: Any,  # noqa: ANN401 - MuJoCo's
        *,
        straight: bool,
    ) -> None:
        """Index the pairs by `bodies` in the compiled `model`, whose state is `data`; `straight`: no joint rotates."""
        self._pairs, self._model, self._data, self._straight = pairs, model, data, straight
        self._ends = [(bodies[pair.a], bodies[pair.b]) for pair in pairs]
        self._first, self._last = [first for first, _ in self._ends], [last for _, last in self._ends]
        self._constants = [pair.constant for pair in pairs]
        self._exponents = np.array([-0.5 * (pair.power + 1.0) for pair in pairs])
        self._bodies = sorted({*self._first, *self._last})
        self._jacobians = np.zeros((int(model.nbody), 3, int(model.nv)))
        self._apart: Array | None = None  # how the Jacobians of each pair differ, where nothing turns
        self._began = np.zeros(0)

    def begin(self) -> None:
        """Store the present distances as those at the start."""
        self._began = np.array(self._squares()[1])

    def closeness(self) -> float:
        """Return the smallest ratio of a pair's present to initial distance, at most 1, to scale the step tolerance.

        When two bodies pass closely, a small error of their positions is a large part of their distance, which
        determines their deflection.
        """
        squares = np.array(self._squares()[1])
        return max(MIN_CLOSENESS, min(1.0, float(np.sqrt((squares / self._began).min()))))

    def _squares(self) -> tuple[list[Vector], list[float]]:
        """Return the separation of the centres of mass of each pair, m, and its square, m²."""
        places: list[list[float]] = self._data.xipos.tolist()
        separations: list[Vector] = []
        for first, last in self._ends:
            (x, y, z), (a, b, c) = places[first], places[last]
            separations.append((a - x, b - y, c - z))
        return separations, [x * x + y * y + z * z for x, y, z in separations]

    def load(self) -> Array:
        """Return the load on the joints, (joints,): constant·m·m′/rᵖ between centres of mass, for present masses."""
        separations, squares = self._squares()
        if 0.0 in squares:
            pair = self._pairs[squares.index(0.0)]
            raise SimulationError(f"{pair.a} and {pair.b} are at one place")
        masses: list[float] = self._model.body_mass.tolist()
        powers = (np.array(squares) ** self._exponents).tolist()
        parts: list[float] = []
        for (first, last), (x, y, z), constant, power in zip(
            self._ends, separations, self._constants, powers, strict=True
        ):
            pull = constant * masses[first] * masses[last] * power
            parts += (pull * x, pull * y, pull * z)
        return np.array(parts).dot(self._jacobians_apart())

    def _jacobians_apart(self) -> Array:
        """Return the derivatives of the vector between the centres of mass of each pair, (3·pairs, joints)."""
        if self._apart is not None:
            return self._apart
        for body in self._bodies:
            mujoco.mj_jacBodyCom(self._model, self._data, self._jacobians[body], None, body)
        moved = (self._jacobians[self._first] - self._jacobians[self._last]).reshape(-1, self._jacobians.shape[2])
        self._apart = moved if self._straight else None
        return moved
