"""The motion of a mechanism as arrays over time, and its initial state: checks, and changes of it.

A two-sided constraint has no jerk at the start, unlike a string: no impulse could have caused inconsistent speeds.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import field, replace
from itertools import pairwise
from math import inf
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from sim2reason.base.records import cached_property, format_count, record
from sim2reason.errors import SceneError, UnsupportedError
from sim2reason.scenes.dsl.frames import BodyFrame, Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import (
    ZERO,
    ConstantTension,
    Coordinate,
    Elastic,
    Inextensible,
    Line,
    LineLaw,
    Mechanism,
    Prop,
    Rigid,
    RigidBody,
    Site,
    SurfaceContact,
)
from sim2reason.scenes.dsl.vectors import Tensor, Triple, dot, subtract_triples

Array = NDArray[np.float64]


class Dynamics(NamedTuple):
    """Accelerations and constraint forces at n instants."""

    a: Array
    constraint_tension: Mapping[str, Array]
    normal: Mapping[str, Array]
    friction: Mapping[str, Array]


@record()
class State:
    """The motion of a mechanism at n instants.

    Positions and forces are evaluated when they are first read. At the time of an event the values are those just after
    it. A force that the mechanism does not determine, as with three supports or two unknown frictions, is NaN; all
    other values are finite.

    Attributes:
        mechanism: The mechanism.
        times: The instants (n,), s.
        kinematics: Function of the instants that returns q and v.
        dynamics: Function of the instants, q and v that returns accelerations and forces.
        q: Coordinates (n, number of coordinates), m or rad, in the order of `mechanism.coordinates`.
        v: Rates of the coordinates, m/s or rad/s.
        a: Accelerations, m/s² or rad/s².
        constraint_tension: Tensions (n,) of lines that give equations, N, by line.
        normal: Normal forces (n,), N, by the body that rests.
        friction: Forces of friction (n,), N, by the body that rests.
        tension: Tensions (n,) of all lines, N, by line.
        frames: Positions and velocities of all parts.
        began: Positions of all parts at the start.
        known: Quantities evaluated so far, by quantity and subject.
    """

    mechanism: Mechanism
    times: Array  # s, (n,)
    kinematics: Callable[[Array], tuple[Array, Array]] = field(repr=False)  # of the instants: q and v
    dynamics: Callable[[Array, Array, Array], Dynamics] = field(repr=False)  # of the instants, q and v

    def __repr__(self) -> str:
        """Return the number of coordinates and of instants, and the first and the last instant."""
        count, unit = format_count(len(self.mechanism.coordinates), "coordinate"), self.mechanism.units.time
        span = f", {self.times[0]:g} to {self.times[-1]:g} {unit}" if len(self.times) else ""
        return f"<State: {count} at {format_count(len(self.times), 'instant')}{span}>"

    @classmethod
    def of(cls, mechanism: Mechanism, times: Array, kinematics: tuple[Array, Array], dynamics: Dynamics) -> Self:
        """Return a state whose coordinates, accelerations and forces are known already."""
        return cls(mechanism, times, lambda _: kinematics, lambda _, __, ___: dynamics)

    @cached_property
    def _kinematics(self) -> tuple[Array, Array]:
        return self.kinematics(self.times)

    @cached_property
    def _dynamics(self) -> Dynamics:
        return self.dynamics(self.times, *self._kinematics)

    @property
    def q(self) -> Array:
        """Return the coordinates, m or rad, (n, number of coordinates)."""
        return self._kinematics[0]

    @property
    def v(self) -> Array:
        """Return the rates of the coordinates, m/s or rad/s, (n, number of coordinates)."""
        return self._kinematics[1]

    @property
    def a(self) -> Array:
        """Return the accelerations, m/s² or rad/s², (n, number of coordinates)."""
        return self._dynamics.a

    @property
    def constraint_tension(self) -> Mapping[str, Array]:
        """Return the tension, N, of each line that gives a constraint equation; negative for a rod that pushes."""
        return self._dynamics.constraint_tension

    @property
    def normal(self) -> Mapping[str, Array]:
        """Return the normal force, N, on each body on a face; negative only on faces that hold in both directions."""
        return self._dynamics.normal

    @property
    def friction(self) -> Mapping[str, Array]:
        """Return the friction force, N, on each body on a face, positive along its slip."""
        return self._dynamics.friction

    @cached_property
    def frames(self) -> Frames:
        """Return the positions of all parts: components are arrays (n,), or floats if they never change."""
        return Frames(self.mechanism, list(self.q.T), list(self.v.T), np)

    @cached_property
    def began(self) -> Frames:
        """Return the positions of all parts at the start."""
        return initial_frames(self.mechanism)

    @cached_property
    def known(self) -> "dict[tuple[str, str], Array]":
        """Return the cached values of quantities, by quantity and subject, from which other quantities are computed."""
        return {}

    @cached_property
    def tension(self) -> Mapping[str, Array]:
        """Return the tension, N, of each line, (n,); negative for a rod or a spring that pushes."""
        given = [line for line in self.mechanism.lines if not line.law.row]
        return {**self.constraint_tension, **{line.name: self._given(line) for line in given}}

    def _given(self, line: Line) -> Array:
        law = line.law
        if isinstance(law, ConstantTension):
            return np.full(len(self.times), law.force)
        assert isinstance(law, Elastic)
        length, rate = self.free_length(line)
        tension = law.stiffness * (length - law.length) + law.damping * rate
        return np.where(law.side * tension >= 0.0, tension, 0.0)

    def mass(self, body: str) -> Array | float:
        """Return the mass of a body; for a body that burns, the remaining mass at each instant, (n,)."""
        remaining: Array | float = self.mechanism.body[body].mass
        for burn in self.mechanism.burns:
            if burn.body == body:
                remaining = remaining - burn.rate * np.minimum(self.times, burn.until)
        return remaining

    def vector(self, components: Triple) -> Array:
        """Return three components as one array, (n, 3)."""
        array = np.empty((len(self.times), 3))
        for number, part in enumerate(components):
            array[:, number] = part
        return array

    def length(self, line: Line) -> tuple[Array, Array]:
        """Return the total distance between the sites of a line, m, and its rate, m/s; both (n,).

        Where two sites coincide, the rate of their distance is undefined and 0 is used.
        """
        length, rate = np.zeros(len(self.times)), np.zeros(len(self.times))
        for first, last in pairwise(line.through):
            one, other = self.frames.site(first), self.frames.site(last)
            separation = subtract_triples(other.place, one.place)
            parting = subtract_triples(other.velocity, one.velocity)
            distance = np.sqrt(dot(separation, separation)) + length * 0.0
            length = length + distance
            rate = rate + dot(separation, parting) / np.where(distance > 0.0, distance, 1.0)
        return length, rate

    def free_length(self, line: Line) -> tuple[Array, Array]:
        """Return the length of a line including the length unwound from its wheels, m, and its rate, m/s; both (n,)."""
        length, rate = self.length(line)
        for wheel in line.wheels:
            number = self.mechanism.number[wheel.coordinate]
            length, rate = length + wheel.radius * self.q[:, number], rate + wheel.radius * self.v[:, number]
        return length, rate


def row_lengths(vectors: Array) -> Array:
    """Return the lengths of vectors, (n, 3), as `np.linalg.norm` computes them, which takes four times as long."""
    return np.sqrt(np.add.reduce(vectors * vectors, axis=1))


LENGTH_TOL = 1e-9  # m; smaller differences count as zero


def displace(mechanism: Mechanism, coordinates: Sequence[float], speeds: Sequence[float]) -> Mechanism:
    """Return the mechanism with other initial `coordinates` (n,), m or rad, and `speeds` (n,).

    The laws do not change: strings and springs keep their lengths. Time and its functions restart at 0.

    Raises:
        UnsupportedError: a strut that only pushes has been left, or a body has slid away from its own hinge.
    """
    frames = Frames(mechanism, coordinates, speeds, math)
    moved = _Displaced(mechanism, frames, coordinates, speeds)
    return replace(
        mechanism,
        bodies=tuple(moved.body(body) for body in mechanism.bodies),
        sites=tuple(moved.site(site) for site in mechanism.sites),
        lines=tuple(moved.line(line) for line in mechanism.lines),
        faces=tuple(moved.face(face) for face in mechanism.faces),
        burns=tuple(replace(burn, direction=frames[burn.body].turned(burn.direction)) for burn in mechanism.burns),
    )


class _Displaced:
    """The converter of the parts of a mechanism to other initial coordinates."""

    def __init__(
        self, mechanism: Mechanism, frames: Frames, coordinates: Sequence[float], speeds: Sequence[float]
    ) -> None:
        """Store the mechanism and its `frames` at the new coordinates."""
        self.mechanism, self.frames = mechanism, frames
        self.coordinates, self.speeds = coordinates, speeds
        rest = [0.0] * len(mechanism.coordinates)
        self.began = Frames(mechanism, rest, rest, math, still=True)

    def body(self, body: RigidBody) -> RigidBody:
        """Return the body at its new position, with the axes of its frame parallel to those of the room."""
        frame, carrier = self.frames[body.name], self.frames[body.parent]
        return replace(
            body,
            at=subtract_triples(frame.origin, carrier.origin),
            center=body.center if body.center is ZERO else frame.turned(body.center),
            inertia=_turned(frame, body.inertia),
            coordinates=tuple(self._coordinate(coordinate, frame) for coordinate in body.coordinates),
        )

    def _coordinate(self, coordinate: Coordinate, frame: BodyFrame) -> Coordinate:
        number = self.mechanism.number[coordinate.name]
        step = next(step for step in frame.steps if step.number == number)
        if step.pivot is not None and math.dist(step.pivot, frame.origin) > LENGTH_TOL:
            raise UnsupportedError(
                f"{coordinate.body}: it has slid away from its own hinge, so nothing can begin there"
            )
        gone = float(self.coordinates[number])
        return replace(
            coordinate,
            axis=step.axis,
            speed=float(self.speeds[number]),
            lower=coordinate.lower - gone,
            upper=coordinate.upper - gone,
            stated=None if coordinate.stated is None else (coordinate.stated[0], coordinate.stated[1] + gone),
        )

    def site(self, site: Site) -> Site:
        """Return the site in the new frame of its body, whose axes are parallel to those of the room."""
        return replace(site, at=self.frames[site.body].turned(site.at)) if site.body is not None else site

    def face(self, face: SurfaceContact) -> SurfaceContact:
        """Return the face with its normal in the new frame of its carrier."""
        carrier = face.subject if face.turning else self.mechanism.body[face.subject].parent
        return replace(face, normal=self.frames[carrier].turned(face.normal))

    def line(self, line: Line) -> Line:
        """Return the line with a law that accounts for the slack that remains and the length wound onto pulleys."""
        return replace(line, law=self._law(line))

    def _law(self, line: Line) -> LineLaw:
        law = line.law
        wound = sum(w.radius * float(self.coordinates[self.mechanism.number[w.coordinate]]) for w in line.wheels)
        if isinstance(law, Elastic):
            return replace(law, length=law.length - wound)
        grown = self.frames.length(line) + wound - self.began.length(line)
        if isinstance(law, Inextensible):
            spare = law.slack - grown
            return replace(law, slack=spare if spare > LENGTH_TOL else 0.0)
        if isinstance(law, Prop) and abs(grown) > LENGTH_TOL:
            raise UnsupportedError(f"{line.name}: the strut has been left, so that no motion begins with it")
        return law


def _turned(frame: BodyFrame, inertia: Tensor) -> Tensor:
    """Return the rotated inertia tensor R I Rᵀ."""
    if frame.rotation is None or not any(inertia):
        return inertia
    xx, yy, zz, xy, xz, yz = inertia
    rows = ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))
    half = [[dot(row, axis) for row in rows] for axis in frame.rotation]  # rows of R I

    def entry(i: int, j: int) -> float:
        return float(dot((half[i][0], half[i][1], half[i][2]), frame.rotation[j]))  # type: ignore[index]

    return (entry(0, 0), entry(1, 1), entry(2, 2), entry(0, 1), entry(0, 2), entry(1, 2))


SPEED_RTOL = 1e-9  # fraction of the largest speed, or of 1 m/s
CONTACT_DISTANCE = 1e-9  # m


def check_initial_speeds(mechanism: Mechanism) -> None:
    """Raise SceneError if initial speeds change the length of a rod or make a nonslipping contact slip."""
    speeds = [float(coordinate.speed) for coordinate in mechanism.coordinates]
    never = [face for face in mechanism.faces if face.friction == inf]
    rods = [line for line in mechanism.lines if isinstance(line.law, Rigid)]
    if not any(speeds) or not (rods or never or mechanism.feet):
        return
    small = SPEED_RTOL * max(1.0, *map(abs, speeds))
    frames = Frames(mechanism, [0.0] * len(speeds), speeds, math)
    for rod in rods:
        rate = _parting(frames, *rod.through)
        if abs(rate) > small:
            problem = f"its ends begin to part at {rate:.6g} m/s, and it is rigid"
            raise SceneError(rod.name, problem, "let both begin with the same speed along it")
    for face in never:
        slip = sum(factor * speeds[mechanism.number[name]] for name, factor in face.slip)
        if abs(slip) > small:
            problem = f"it begins to slip at {slip:.6g} m/s where it never slips"
            raise SceneError(face.subject, problem, "let it begin without slipping, or give a coefficient of friction")
    _check_feet(mechanism, frames, small)


def _parting(frames: Frames, first: str, last: str) -> float:
    try:
        return float(frames.distance(first, last).rate)
    except ZeroDivisionError:  # they coincide, which engines refuse for itself
        return 0.0


def _check_feet(mechanism: Mechanism, frames: Frames, small: float) -> None:
    for foot in mechanism.feet:
        point = frames.site(foot.site)
        stands = abs(dot(foot.normal, point.place) - foot.height) <= CONTACT_DISTANCE
        slip = dot(foot.along, point.velocity)
        if stands and abs(dot(foot.normal, point.velocity)) <= small < abs(slip):
            problem = f"it stands, and yet begins to slip at {slip:.6g} m/s"
            raise SceneError(foot.name, problem, "let it begin at rest")
