"""Positions and motions of the parts of a mechanism, for floats, arrays or symbols.

The tree of bodies is traversed once, with floats for the initial geometry, with arrays for all instants of a motion,
with symbols for equations of motion. Only + − × and the caller's sine and cosine are used. A *point* has its position,
velocity, acceleration at q̈ = 0 (so that no gradient need be differentiated), its gradient by each coordinate, and its
gradient by the rise of a body from its face.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from types import MappingProxyType

from sim2reason.scenes.dsl.mechanism import ZERO, Coordinate, Line, Mechanism, RigidBody
from sim2reason.scenes.dsl.vectors import (
    Distance,
    Gradient,
    Maths,
    Number,
    Point,
    Triple,
    Vector,
    add_triples,
    cross,
    distance,
    dot,
    scale_triple,
    subtract_triples,
)

Rotation = tuple[Triple, Triple, Triple]  # rows


@dataclass(slots=True)
class Turning:
    """The rotation of a body, in the axes of the room."""

    velocity: Triple  # rad/s
    bias: Triple  # angular acceleration at q̈ = 0, rad/s²
    gradient: Gradient


@dataclass(slots=True)
class Step:
    """One coordinate in the chain from the room to a body, with its present direction."""

    number: int
    axis: Triple
    pivot: Triple | None  # a point of the axis of a hinge; None for a slide


@dataclass(slots=True)
class BodyFrame:
    """The frame of a body at one instant, or at all instants."""

    origin: Triple
    rotation: Rotation | None  # None: the axes of the room
    velocity: Triple
    bias: Triple
    spin: Triple | None  # angular velocity; None: the body never rotates
    spin_bias: Triple
    steps: tuple[Step, ...]
    lift: Gradient

    def turned(self, vector: Triple) -> Triple:
        """Return a vector given in this frame, in the axes of the room."""
        if self.rotation is None:
            return vector
        return (dot(self.rotation[0], vector), dot(self.rotation[1], vector), dot(self.rotation[2], vector))

    def to_body_axes(self, vector: Triple) -> Triple:
        """Return a vector given in the axes of the room, in this frame."""
        if self.rotation is None:
            return vector
        a, b, c = self.rotation
        columns = ((a[0], b[0], c[0]), (a[1], b[1], c[1]), (a[2], b[2], c[2]))
        return (dot(columns[0], vector), dot(columns[1], vector), dot(columns[2], vector))

    def point(self, at: Triple = ZERO) -> Point:
        """Return a point fixed in this frame."""
        arm = self.turned(at)
        position = self.origin if at is ZERO else add_triples(self.origin, arm)
        if self.spin is None:
            return Point(position, self.velocity, self.bias, {step.number: step.axis for step in self.steps}, self.lift)
        gradient = {
            step.number: step.axis if step.pivot is None else cross(step.axis, subtract_triples(position, step.pivot))
            for step in self.steps
        }
        velocity, bias = self.point_motion(arm)
        return Point(position, velocity, bias, gradient, self.lift)

    def point_motion(self, arm: Triple) -> tuple[Triple, Triple]:
        """Return velocity and bias (acceleration at q̈ = 0) of a point at `arm` from the origin, in the room's axes."""
        if self.spin is None or self.spin is ZERO:
            return self.velocity, self.bias
        swing = cross(self.spin, arm)
        return add_triples(self.velocity, swing), add_triples(
            self.bias, add_triples(cross(self.spin_bias, arm), cross(self.spin, swing))
        )

    @property
    def hinges(self) -> tuple[Step, ...]:
        """Return the hinges between the room and the body."""
        return tuple(step for step in self.steps if step.pivot is not None)

    @property
    def turning(self) -> Turning:
        """Return the angular velocity, its derivative at q̈ = 0 (bias) and its gradient by coordinate, of the frame."""
        gradient = {step.number: step.axis for step in self.steps if step.pivot is not None}
        return Turning(self.spin or ZERO, self.spin_bias, gradient)


NONE_STEADY: Mapping[tuple[str, str], Triple] = MappingProxyType({})
ROOM = BodyFrame(ZERO, None, ZERO, ZERO, None, ZERO, (), MappingProxyType({}))


class Frames:
    """The frames of all bodies of a mechanism for given coordinates and rates."""

    def __init__(
        self,
        mechanism: Mechanism,
        q: Sequence[Number],
        v: Sequence[Number],
        maths: Maths,
        *,
        still: bool = False,
        steady: Mapping[tuple[str, str], Triple] = NONE_STEADY,
    ) -> None:
        """Store coordinates `q` and rates `v` in the mechanism's order; `still` if all are zero.

        `steady` has the directions between sites that are known to be constant.
        """
        self._mechanism, self._q, self._v, self._maths = mechanism, q, v, maths
        self._still, self._steady = still, steady
        self._frames: dict[str | None, BodyFrame] = {None: ROOM}
        self._centers: dict[str, Point] = {}
        self._sites: dict[str, Point] = {}
        self._distances: dict[tuple[str, str], Distance] = {}
        self._pieces: dict[str, tuple[Distance, ...]] = {}

    def __getitem__(self, body: str | None) -> BodyFrame:
        """Return the frame of a body, computed on demand; None gives that of the room."""
        frame = self._frames.get(body)
        if frame is None:
            assert body is not None
            rigid_body = self._mechanism.body[body]
            frame = self._frames[body] = self._at_rest(rigid_body) if self._still else self._compute_frame(rigid_body)
        return frame

    def center(self, body: str) -> Point:
        """Return the centre of mass of a body as a point."""
        point = self._centers.get(body)
        if point is None:
            point = self._centers[body] = self[body].point(self._mechanism.body[body].center)
        return point

    def site(self, name: str) -> Point:
        """Return a site as a point."""
        point = self._sites.get(name)
        if point is None:
            site = self._mechanism.site[name]
            point = self._sites[name] = self[site.body].point(site.at)
        return point

    def distance(self, first: str, last: str) -> Distance:
        """Return the distance between two sites; raise ZeroDivisionError if they coincide and can separate."""
        separation = self._distances.get((first, last))
        if separation is None:
            steady = self._steady.get((first, last))
            separation = self._distances[first, last] = distance(self.site(first), self.site(last), self._maths, steady)
        return separation

    def pieces(self, line: Line) -> tuple[Distance, ...]:
        """Return the straight segments of a line, end to end; ZeroDivisionError if the ends of one coincide."""
        segments = self._pieces.get(line.name)
        if segments is None:
            segments = tuple([self.distance(first, last) for first, last in pairwise(line.through)])
            self._pieces[line.name] = segments
        return segments

    def length(self, line: Line) -> Number:
        """Return the sum of the distances between the sites of a line, m."""
        total: Number = 0.0
        for first, last in pairwise(line.through):
            separation = subtract_triples(self.site(last).place, self.site(first).place)
            total = total + self._maths.sqrt(dot(separation, separation))
        return total

    def normal(self, subject: str) -> Triple:
        """Return the outward normal of the face on which a body lies, in the axes of the room."""
        face = self._mechanism.contacts[subject]
        carrier = subject if face.turning else self._mechanism.body[subject].parent
        return self[carrier].turned(face.normal)

    def _at_rest(self, body: RigidBody) -> BodyFrame:
        """Return the initial frame of a body, which has the axes of the room."""
        carrier = self[body.parent]
        origin = carrier.origin if body.at is ZERO else add_triples(carrier.origin, body.at)
        steps, spin, lift = carrier.steps, carrier.spin, carrier.lift
        for coordinate in body.coordinates:
            number = self._mechanism.number[coordinate.name]
            if coordinate.kind == "slide":
                steps = (*steps, Step(number, coordinate.axis, None))
            else:
                steps, spin = (*steps, Step(number, coordinate.axis, origin)), ZERO
        face = self._mechanism.contacts.get(body.name)
        if face is not None:
            lift = {**lift, self._mechanism.face_number[body.name]: face.normal}
        return BodyFrame(origin, None, ZERO, ZERO, spin, ZERO, steps, lift)

    def _compute_frame(self, body: RigidBody) -> BodyFrame:
        frame = self[body.parent]
        if body.at != ZERO:
            frame = _shifted(frame, frame.turned(body.at))
        for coordinate in body.coordinates:
            number = self._mechanism.number[coordinate.name]
            if coordinate.kind == "slide":
                frame = self._slid(frame, coordinate, number)
            else:
                frame = self._hinged(frame, coordinate, number)
        face = self._mechanism.contacts.get(body.name)
        if face is None:
            return frame
        carrier = frame if face.turning else self[body.parent]
        lift = {**frame.lift, self._mechanism.face_number[body.name]: carrier.turned(face.normal)}
        return BodyFrame(
            frame.origin,
            frame.rotation,
            frame.velocity,
            frame.bias,
            frame.spin,
            frame.spin_bias,
            frame.steps,
            lift,
        )

    def _slid(self, frame: BodyFrame, coordinate: Coordinate, number: int) -> BodyFrame:
        axis = frame.turned(coordinate.axis)
        arm = _along(axis, self._q[number])
        velocity, bias = frame.point_motion(arm)
        velocity = add_triples(velocity, _along(axis, self._v[number]))
        if frame.spin is not None:
            bias = add_triples(bias, scale_triple(2.0 * self._v[number], cross(frame.spin, axis)))
        steps = (*frame.steps, Step(number, axis, None))
        origin = add_triples(frame.origin, arm)
        return BodyFrame(origin, frame.rotation, velocity, bias, frame.spin, frame.spin_bias, steps, frame.lift)

    def _hinged(self, frame: BodyFrame, coordinate: Coordinate, number: int) -> BodyFrame:
        axis = frame.turned(coordinate.axis)
        whirl = scale_triple(self._v[number], axis)
        if frame.spin is None:
            spin, spin_bias = whirl, frame.spin_bias
        else:
            spin, spin_bias = add_triples(frame.spin, whirl), add_triples(frame.spin_bias, cross(frame.spin, whirl))
        rotation = rotated(frame.rotation, coordinate.axis, self._q[number], self._maths)
        steps = (*frame.steps, Step(number, axis, frame.origin))
        return BodyFrame(frame.origin, rotation, frame.velocity, frame.bias, spin, spin_bias, steps, frame.lift)


def _along(axis: Triple, size: Number) -> Triple:
    """Return a number times an axis; zero components remain floats even if others are arrays."""
    x, y, z = axis
    if type(x) is float and type(y) is float and type(z) is float:
        return (size * x if x else 0.0, size * y if y else 0.0, size * z if z else 0.0)
    return scale_triple(size, axis)


def _shifted(frame: BodyFrame, arm: Triple) -> BodyFrame:
    """Return the frame with its origin shifted by `arm`, in the axes of the room."""
    velocity, bias = frame.point_motion(arm)
    origin = add_triples(frame.origin, arm)
    return BodyFrame(origin, frame.rotation, velocity, bias, frame.spin, frame.spin_bias, frame.steps, frame.lift)


def rotated(rotation: Rotation | None, axis: Vector, angle: Number, maths: Maths) -> Rotation:
    """Return a rotation followed by one about the unit vector `axis` of the rotated frame (Rodrigues)."""
    c, s = maths.cos(angle), maths.sin(angle)
    x, y, z = axis

    def entry(i: int, j: int, skew: float) -> Number:
        both, same = axis[i] * axis[j], 1.0 if i == j else 0.0
        element: Number = both if same - both == 0.0 else (same - both) * c + both
        return element + skew * s if skew else element

    turn = (
        (entry(0, 0, 0.0), entry(0, 1, -z), entry(0, 2, y)),
        (entry(1, 0, z), entry(1, 1, 0.0), entry(1, 2, -x)),
        (entry(2, 0, -y), entry(2, 1, x), entry(2, 2, 0.0)),
    )
    if rotation is None:
        return turn
    columns = tuple((turn[0][j], turn[1][j], turn[2][j]) for j in range(3))
    rows = [(dot(row, columns[0]), dot(row, columns[1]), dot(row, columns[2])) for row in rotation]
    return (rows[0], rows[1], rows[2])


RECENT_MECHANISMS = 16  # number of mechanisms with cached initial frames
_recent: tuple[tuple[Mechanism, Frames], ...] = ()  # not in the mechanisms: cycles would burden the garbage collector


def initial_frames(mechanism: Mechanism) -> Frames:
    """Return the initial frames, with all velocities zero, cached for recent mechanisms."""
    global _recent  # noqa: PLW0603 - replaced as a whole, so that threads need no lock
    for known, frames in _recent:
        if known is mechanism:
            return frames
    rest = [0.0] * len(mechanism.coordinates)
    frames = Frames(mechanism, rest, rest, math, still=True)
    _recent = ((mechanism, frames), *_recent[: RECENT_MECHANISMS - 1])
    return frames
