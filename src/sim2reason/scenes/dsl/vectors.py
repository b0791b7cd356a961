"""Vectors in space, points of bodies, and regions in which forces act."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from math import hypot
from typing import Any, Protocol, Self, TypeAlias

Vector = tuple[float, float, float]
Tensor = tuple[float, float, float, float, float, float]
"""A symmetric tensor: xx, yy, zz, xy, xz, yz."""


def unit(vector: Vector) -> Vector:
    """Return a vector scaled to length 1; raise ValueError for the zero vector."""
    length = hypot(*vector)
    if length == 0.0:
        raise ValueError("a direction can not be the zero vector")
    return (vector[0] / length, vector[1] / length, vector[2] / length)


def add(*vectors: Vector) -> Vector:
    """Return the sum of vectors.

    Args:
        *vectors: Vectors of three components.

    Returns:
        The sum.

    Examples:
        >>> from sim2reason.authoring import X, Z, add
        >>> add(X, Z, Z)
        (1.0, 0.0, 2.0)
    """
    if len(vectors) == 2:  # as nearly always
        a, b = vectors
        return (a[0] + b[0], a[1] + b[1], a[2] + b[2])
    x = y = z = 0.0
    for vector in vectors:
        x, y, z = x + vector[0], y + vector[1], z + vector[2]
    return (x, y, z)


def scale(factor: float, vector: Vector) -> Vector:
    """Return a multiple of a vector.

    Args:
        factor: The factor.
        vector: The vector.

    Returns:
        `factor` times `vector`.

    Examples:
        >>> from sim2reason.authoring import X, scale
        >>> scale(2.0, X)
        (2.0, 0.0, 0.0)
    """
    return (factor * vector[0], factor * vector[1], factor * vector[2])


def inner(a: Vector, b: Vector) -> float:
    """Return the dot product of two vectors.

    Args:
        a: The first vector.
        b: The second vector.

    Returns:
        The sum of the products of their components.

    Examples:
        >>> from sim2reason.authoring import inner
        >>> inner((1.0, 2.0, 3.0), (0.0, 1.0, 1.0))
        5.0
    """
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def outer(a: Vector, b: Vector) -> Vector:
    """Return the cross product of two vectors.

    Args:
        a: The first vector.
        b: The second vector.

    Returns:
        The vector a × b, at right angles to both.

    Examples:
        >>> from sim2reason.authoring import X, Y, outer
        >>> outer(X, Y)
        (0.0, 0.0, 1.0)
    """
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


Number: TypeAlias = Any  # a float, an array or a symbol with arithmetic
Triple: TypeAlias = tuple[Number, Number, Number]


class Maths(Protocol):
    """The functions of one type of number: the modules `math` and `numpy`, or a tape of symbols."""

    def sqrt(self, x: Number, /) -> Number:
        """Return the square root."""
        ...

    def sin(self, x: Number, /) -> Number:
        """Return the sine of an angle, rad."""
        ...

    def cos(self, x: Number, /) -> Number:
        """Return the cosine of an angle, rad."""
        ...


def dot(a: Triple, b: Triple) -> Number:
    """Return the dot product of two vectors."""
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a: Triple, b: Triple) -> Triple:
    """Return the cross product of two vectors."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def add_triples(a: Triple, b: Triple) -> Triple:
    """Return the sum of two vectors."""
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def subtract_triples(a: Triple, b: Triple) -> Triple:
    """Return the first vector minus the second."""
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def scale_triple(factor: Number, a: Triple) -> Triple:
    """Return a vector times a number."""
    return (factor * a[0], factor * a[1], factor * a[2])


def apply_tensor(tensor: Tensor, vector: Triple) -> Triple:
    """Return a symmetric tensor times a vector."""
    xx, yy, zz, xy, xz, yz = tensor
    return (dot((xx, xy, xz), vector), dot((xy, yy, yz), vector), dot((xz, yz, zz), vector))


Gradient = Mapping[int, Triple]  # by index of a coordinate, or of a face
NULL_VECTOR: Triple = (0.0, 0.0, 0.0)


@dataclass(slots=True)
class Point:
    """A point of a body; its gradient has nonzero entries by coordinate, and by face for moves off it (`lift`)."""

    place: Triple  # m
    velocity: Triple  # m/s
    bias: Triple  # acceleration at q̈ = 0, m/s²
    gradient: Gradient
    lift: Gradient


@dataclass(slots=True)
class Distance:
    """The distance of two points with its derivatives; entries are omitted if they are zero."""

    value: Number  # m
    rate: Number  # m/s
    bias: Number  # second derivative at q̈ = 0, m/s²
    direction: Triple  # unit vector from the first to the second
    moved: Gradient  # gradient of the relative position, by coordinate
    along: Mapping[int, Number]  # its component along `direction`
    lift: Mapping[int, Number]  # the same for rises from faces


def distance(one: Point, other: Point, maths: Maths, steady: Triple | None = None) -> Distance:
    """Return the distance between two points; raise ZeroDivisionError if they coincide and can separate.

    `steady` is the unit vector from one to the other if it is constant: it also applies where they meet, and beyond,
    where their distance counts as negative.
    """
    separation = x, y, z = subtract_triples(other.place, one.place)
    value = maths.sqrt(x * x + y * y + z * z) if steady is None else dot(steady, separation)
    moved, risen = relative(one.gradient, other.gradient), relative(one.lift, other.lift)
    if not moved and not risen:
        return Distance(value, 0.0, 0.0, NULL_VECTOR, {}, {}, {})
    direction = x, y, z = scale_triple(1.0 / value, separation) if steady is None else steady
    along = {i: x * dx + y * dy + z * dz for i, (dx, dy, dz) in moved.items()}
    lift = {i: dot(direction, normal) for i, normal in risen.items()} if risen else {}
    if one.velocity is other.velocity and one.bias is other.bias:  # above all where nothing moves yet
        return Distance(value, 0.0, 0.0, direction, moved, along, lift)
    parting = subtract_triples(other.velocity, one.velocity)
    rate = dot(direction, parting)
    bend = dot(direction, subtract_triples(other.bias, one.bias))
    bias = bend if steady is not None else bend + (dot(parting, parting) - rate * rate) / value
    return Distance(value, rate, bias, direction, moved, along, lift)


def relative(one: Gradient, other: Gradient) -> dict[int, Triple]:
    """Return the gradient of the second point relative to the first, nonzero entries in the order of coordinates."""
    if not one:
        return dict(other)
    if not other:
        return {i: (-vector[0], -vector[1], -vector[2]) for i, vector in one.items()}
    difference: dict[int, Triple] = {}
    for i in sorted(one.keys() | other.keys()):
        mine, its = one.get(i), other.get(i)
        if mine is None:
            difference[i] = other[i]
        elif its is None:
            difference[i] = (-mine[0], -mine[1], -mine[2])
        elif mine != its:
            difference[i] = subtract_triples(its, mine)
    return difference


class Region(Protocol):
    """The protocol of regions in which a force acts; at a point inside, the distances to all borders are positive."""

    def margins(self, place: Triple, maths: Maths) -> tuple[Number, ...]:
        """Return the distances to the borders, m, positive inside."""
        ...

    def moved(self, by: Vector) -> Self:
        """Return the region translated by a vector, m."""
        ...


@dataclass(frozen=True, slots=True)
class HalfSpace:
    """The half-space normal·r ≥ offset."""

    normal: Vector
    offset: float

    def margins(self, place: Triple, maths: Maths) -> tuple[Number, ...]:
        """Return the distance to the plane, m, positive inside."""
        del maths
        return (dot(self.normal, place) - self.offset,)

    def moved(self, by: Vector) -> "HalfSpace":
        """Return the region translated by a vector, m."""
        return replace(self, offset=self.offset + inner(self.normal, by))


@dataclass(frozen=True, slots=True)
class BoxRegion:
    """A slab or box: low ≤ axis·r ≤ high for each of its axes."""

    sides: tuple[tuple[Vector, float, float], ...]  # (axis, low, high)

    def margins(self, place: Triple, maths: Maths) -> tuple[Number, ...]:
        """Return the distances to the sides, m, positive inside."""
        del maths
        distances: list[Number] = []
        for axis, low, high in self.sides:
            along = dot(axis, place)
            distances += [along - low, high - along]
        return tuple(distances)

    def moved(self, by: Vector) -> "BoxRegion":
        """Return the region translated by a vector, m."""
        return BoxRegion(tuple((axis, low + inner(axis, by), high + inner(axis, by)) for axis, low, high in self.sides))


@dataclass(frozen=True, slots=True)
class DiscRegion:
    """An infinite cylinder: the points within `radius` of an axis through `center`."""

    center: Vector
    radius: float
    axis: Vector = (0.0, 0.0, 1.0)

    def margins(self, place: Triple, maths: Maths) -> tuple[Number, ...]:
        """Return the distance to the border, m, positive inside."""
        offset = subtract_triples(place, self.center)
        along = dot(self.axis, offset)
        aside = subtract_triples(offset, scale_triple(along, self.axis))
        return (self.radius - maths.sqrt(dot(aside, aside)),)

    def moved(self, by: Vector) -> "DiscRegion":
        """Return the region translated by a vector, m."""
        return replace(self, center=add(self.center, by))
