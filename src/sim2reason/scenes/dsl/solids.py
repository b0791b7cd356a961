"""Uniform rigid bodies with extent: their volumes, centres of mass and moments of inertia in closed form."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from math import cos, exp, log, pi, sin
from typing import Annotated, Any, ClassVar, Literal

import numpy as np
from annotated_types import Ge, Le

from sim2reason.scenes.dsl.body import Axial, Body, Capped, Rectangular, Spherical
from sim2reason.scenes.dsl.builder import Frame
from sim2reason.scenes.dsl.measures import LEAST, Mass, Measure, Range
from sim2reason.scenes.dsl.mechanism import ZERO, X, Y, Z
from sim2reason.scenes.dsl.model import field_types, round_as_stated
from sim2reason.scenes.dsl.template import Word
from sim2reason.scenes.dsl.vectors import Tensor, Vector, add, inner, outer, scale, unit

Axes = tuple[Vector, Vector, Vector]
"""The orientation of a figure: directions of its own x, y and z axes, orthogonal unit vectors."""

UPRIGHT: Axes = (X, Y, Z)
OVERTURNED: Axes = (X, (0.0, -1.0, 0.0), (0.0, 0.0, -1.0))  # rotated by half a turn about x
TENSOR_INDICES = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))  # the entries of a symmetric tensor, in order


@dataclass(frozen=True, slots=True)
class Solid:
    """A uniform mass distribution in a solid, surface or line, whose size is a volume, an area or a length."""

    size: float  # m³, m² or m
    center: Vector  # its centroid, m
    second: Tensor  # ∫ (r − c)(r − c)ᵀ over it, about the centroid: size times m²

    def inertia(self, mass: float) -> Tensor:
        """Return the tensor of inertia about the centroid, kg m²: ρ ∫ (r² 1 − r rᵀ)."""
        xx, yy, zz, xy, xz, yz = (mass / self.size * part for part in self.second)
        return (yy + zz, xx + zz, xx + yy, -xy, -xz, -yz)

    def moved(self, by: Vector) -> "Solid":
        """Return the mass distribution translated by a vector, m."""
        return Solid(self.size, add(self.center, by), self.second)

    def turned(self, axes: Axes) -> "Solid":
        """Return the mass distribution rotated about the origin."""
        entries = [(i, j, part) for (i, j), part in zip(TENSOR_INDICES, self.second, strict=True)]
        both = [*entries, *((j, i, part) for i, j, part in entries if i != j)]
        xx, yy, zz, xy, xz, yz = (sum(part * axes[i][p] * axes[j][q] for i, j, part in both) for p, q in TENSOR_INDICES)
        center = add(*(scale(part, axis) for part, axis in zip(self.center, axes, strict=True)))
        return Solid(self.size, center, (xx, yy, zz, xy, xz, yz))

    def __add__(self, other: "Solid") -> "Solid":
        """Return the union of two mass distributions of the same density."""
        size = self.size + other.size
        if size == 0.0:
            return NOTHING
        separation = add(other.center, scale(-1.0, self.center))
        share = self.size * other.size / size
        parts = (a + b for a, b in zip(self.second, other.second, strict=True))
        xx, yy, zz, xy, xz, yz = (
            p + share * separation[i] * separation[j] for p, (i, j) in zip(parts, TENSOR_INDICES, strict=True)
        )
        return Solid(size, add(self.center, scale(other.size / size, separation)), (xx, yy, zz, xy, xz, yz))

    def __neg__(self) -> "Solid":
        """Return the mass distribution with negative density, as a hole."""
        xx, yy, zz, xy, xz, yz = self.second
        return Solid(-self.size, self.center, (-xx, -yy, -zz, -xy, -xz, -yz))

    def __sub__(self, other: "Solid") -> "Solid":
        """Return the first mass distribution without the second, which lies inside the first."""
        return self + (-other)


NOTHING = Solid(0.0, ZERO, (0.0, 0.0, 0.0, 0.0, 0.0, 0.0))


@lru_cache(maxsize=64)
def axes_along(axis: Vector) -> Axes:
    """Return axes with z along a unit vector; the direction of x is arbitrary."""
    aside = X if abs(axis[0]) < 0.7 else Z
    across = unit(outer(aside, axis))
    return (outer(across, axis), across, axis)


def compose_axes(axes: Axes, then: Axes) -> Axes:
    """Return the orientation after two successive rotations."""
    x, y, z = (add(*(scale(part, image) for part, image in zip(axis, then, strict=True))) for axis in axes)
    return (x, y, z)


def transposed(axes: Axes) -> Axes:
    """Return the inverse orientation."""
    x, y, z = zip(*axes, strict=True)
    return (x, y, z)


def in_own_axes(direction: Vector, axes: Axes) -> Vector:
    """Return the components of a direction along the given axes, those of a rotated body."""
    return (inner(direction, axes[0]), inner(direction, axes[1]), inner(direction, axes[2]))


def _even(size: float, xx: float, yy: float, zz: float, height: float = 0.0) -> Solid:
    """Return a mass distribution with its centroid at z = `height` and mean squares of x, y and z about it, m²."""
    return Solid(size, (0.0, 0.0, height), (size * xx, size * yy, size * zz, 0.0, 0.0, 0.0))


# ---- primitives, each about its centre unless it says otherwise


def point() -> Solid:
    """Return a point mass without extent."""
    return _even(1.0, 0.0, 0.0, 0.0)


def ball(radius: float) -> Solid:
    """Return a solid sphere: ⟨x²⟩ = r²/5."""
    square = radius**2 / 5.0
    return _even(4.0 / 3.0 * pi * radius**3, square, square, square)


def sphere_surface(radius: float) -> Solid:
    """Return a thin spherical shell: ⟨x²⟩ = r²/3."""
    square = radius**2 / 3.0
    return _even(4.0 * pi * radius**2, square, square, square)


def cylinder(radius: float, height: float) -> Solid:
    """Return a solid cylinder about z: ⟨x²⟩ = r²/4, ⟨z²⟩ = h²/12."""
    return _even(pi * radius**2 * height, radius**2 / 4.0, radius**2 / 4.0, height**2 / 12.0)


def disc(radius: float) -> Solid:
    """Return a thin disc about z."""
    return _even(pi * radius**2, radius**2 / 4.0, radius**2 / 4.0, 0.0)


def ring(radius: float) -> Solid:
    """Return a thin ring about z: ⟨x²⟩ = r²/2."""
    return _even(2.0 * pi * radius, radius**2 / 2.0, radius**2 / 2.0, 0.0)


def rod(length: float) -> Solid:
    """Return a thin rod along z: ⟨z²⟩ = l²/12."""
    return _even(length, 0.0, 0.0, length**2 / 12.0)


def box(a: float, b: float, c: float) -> Solid:
    """Return a rectangular bar with edges along x, y and z."""
    return _even(a * b * c, a * a / 12.0, b * b / 12.0, c * c / 12.0)


def polygon(sides: int, radius: float) -> Solid:
    """Return a thin regular polygon about z, inscribed in a circle of `radius`."""
    square = _polygon_square(sides, radius)
    return _even(_polygon_area(sides, radius), square, square, 0.0)


def prism(sides: int, radius: float, height: float) -> Solid:
    """Return a regular prism about z; its cross-section is inscribed in a circle of `radius`."""
    square = _polygon_square(sides, radius)
    return _even(_polygon_area(sides, radius) * height, square, square, height**2 / 12.0)


def _polygon_area(sides: int, radius: float) -> float:
    return 0.5 * sides * radius**2 * sin(2.0 * pi / sides)


def _polygon_square(sides: int, radius: float) -> float:
    """Return ⟨x²⟩ = ⟨y²⟩ in m², for n ≥ 3: each of the n triangles has ⟨ρ²⟩ = r²(2 + cos 2π/n)/6 about the axis."""
    return radius**2 * (2.0 + cos(2.0 * pi / sides)) / 12.0


def segment(radius: float, height: float) -> Solid:
    """Return the segment of a ball with its flat face at z = 0 and its pole at z = `height` ≤ 2r.

    At a depth u below the pole the cross-section has the radius √(u(2r − u)); all moments are polynomials of h.
    """
    r, h = radius, height
    size = pi * h**2 * (r - h / 3.0)
    if size <= 0.0:  # balls that touch within rounding share no more
        return NOTHING
    depth = pi * h**3 * (2.0 * r / 3.0 - h / 4.0) / size
    zz = pi * h**4 * (r / 2.0 - h / 5.0) / size - depth**2
    xx = pi / 4.0 * h**3 * (4.0 / 3.0 * r**2 - r * h + h**2 / 5.0) / size
    return _even(size, xx, xx, zz, h - depth)


def lens(radius: float, other: float, distance: float) -> Solid:
    """Return the intersection of two balls: `radius` about the origin, radius `other` about z = `distance` ≥ 0."""
    if distance >= radius + other:
        return NOTHING
    if distance + other <= radius:
        return ball(other).moved((0.0, 0.0, distance))
    if distance + radius <= other:
        return ball(radius)
    plane = (distance**2 + radius**2 - other**2) / (2.0 * distance)
    upper = segment(radius, radius - plane)
    lower = segment(other, plane - (distance - other)).turned(OVERTURNED)
    return (upper + lower).moved((0.0, 0.0, plane))


MAX_SIZE = Le(1e2)
Radius = Annotated[float, LEAST, MAX_SIZE, Measure("radius", "m", "R", sought=0.3), Range(0.05, 0.15)]
HoleRadius = Annotated[float, LEAST, MAX_SIZE, Measure("hole radius", "m", "r"), Range(0.02, 0.05)]
HoleOffset = Annotated[float, Ge(0), MAX_SIZE, Measure("offset", "m", "d", called="distance"), Range(0.02, 0.05)]
Thickness = Annotated[float, LEAST, MAX_SIZE, Measure("thickness", "m", "t"), Range(0.01, 0.03)]
Extent = Annotated[float, LEAST, MAX_SIZE, Measure("height", "m", "h"), Range(0.05, 0.3)]

Overlooked = Literal["hole", "wall", "section", "height"]
"""A simplification of a shape: no hole, a thin wall, a thin rod (no section) or a thin disc (no height)."""


DRAWN = Range(150.0, 9000.0)  # kg/m³, densities of random draws


class Shape(Body):
    """The base class of uniform rigid bodies with extent.

    The origin of its own axes is the centre named in texts, z its axis, or the direction of its pole or hole. `axis` is
    the word for the line along z.
    """

    mass: Mass

    bulky: ClassVar[bool] = False  # whether the text states all sizes, so that `solid` is three-dimensional
    seen: ClassVar[Axes] = UPRIGHT  # directions of the axes of the drawn shape, in its own axes
    words: ClassVar[dict[str, Word]] = {"axis": Word("mass", {}, "axis")}

    @property
    def solid(self) -> Solid:
        """Return the uniform mass distribution of the body."""
        raise NotImplementedError

    @property
    def density(self) -> float | None:
        """Return the mass divided by the volume, kg/m³; None if sizes are not stated."""
        return self.mass / self.solid.size if self.bulky else None

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return a mass that suits the size, within the range of masses if possible."""
        if not cls.bulky:
            return {}
        mass = field_types(cls)["mass"].drawn or Range(drawn["mass"], drawn["mass"])
        volume = cls(**drawn).solid.size
        low, high = (min(max(end / volume, DRAWN.low), DRAWN.high) for end in (mass.low, mass.high))
        if low <= drawn["mass"] / volume <= high:
            return {}
        density = exp(rng.uniform(log(low), log(max(high, min(2.0 * low, DRAWN.high)))))
        return {"mass": round_as_stated(cls, "mass", density * volume)}

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """Return simplified mass distributions of the same mass and centre, by the detail that each overlooks."""
        return {}

    def reach(self, way: Vector) -> float:
        """Return the extent from the origin along a unit vector, m."""
        look = self.look
        if self.seen != UPRIGHT or not isinstance(look, Axial | Capped | Rectangular | Spherical):
            raise NotImplementedError
        return look.reach(way)

    def put(self, carrier: Frame, name: str, at: Vector, axes: Axes = UPRIGHT) -> Frame:
        """Add the body to its carrier, with its origin at a point and the given orientation."""
        turned = self.solid.turned(axes)
        frame = carrier.body(name, self.mass, at=at, center=turned.center, inertia=turned.inertia(self.mass))
        return frame.turned(compose_axes(self.seen, axes))
