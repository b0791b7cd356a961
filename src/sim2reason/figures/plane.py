"""Plane geometry on complex numbers, x to the right, y up, and the projection of the world frame to the plane."""

from cmath import phase
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise

from sim2reason.scenes.dsl.mechanism import Mechanism, RigidBody, X, Y, Z
from sim2reason.scenes.dsl.vectors import Vector, add, inner, outer, scale, unit

Polygon = tuple[complex, ...]
Box = tuple[float, float, float, float]  # left, bottom, right, top
UP, RIGHT = 1j, 1.0 + 0.0j
ZERO_COMPONENT_TOL = 1e-15  # smaller components of a direction are rounding errors
MIN_SLOPE = 1e-5  # smallest slope that is drawn as inclined, and its counterpart for steep lines


def dot(a: complex, b: complex) -> float:
    """Return the scalar product."""
    return a.real * b.real + a.imag * b.imag


def cross(a: complex, b: complex) -> float:
    """Return the z component of the vector product: positive if `b` is to the left of `a`."""
    return a.real * b.imag - a.imag * b.real


def unit_vector(a: complex) -> complex:
    """Return `a` scaled to length 1; ZeroDivisionError for zero."""
    return a / abs(a)


def drawn_direction(uphill: complex) -> complex:
    """Return the direction in which a slope is drawn; horizontal or vertical only if it is exactly so."""
    rise = max(uphill.imag, MIN_SLOPE) if uphill.imag > ZERO_COMPONENT_TOL else 0.0
    run = max(abs(uphill.real), MIN_SLOPE) if abs(uphill.real) > ZERO_COMPONENT_TOL else 0.0
    return complex(round(-run if uphill.real < 0.0 else run, 9), round(rise, 9))


def mirror(a: complex) -> complex:
    """Return `a` mirrored at a vertical line."""
    return complex(-a.real, a.imag)


def degrees(a: complex) -> float:
    """Return the direction of `a` in degrees, counterclockwise from the x axis."""
    return phase(a) * 57.29577951308232


def hull(points: Iterable[complex]) -> Polygon:
    """Return the convex hull of points, counterclockwise."""
    ordered = sorted(set(points), key=lambda p: (p.real, p.imag))
    if len(ordered) < 3:
        return tuple(ordered)
    lower, upper = _chain(ordered), _chain(ordered[::-1])
    return (*lower[:-1], *upper[:-1])


def _chain(points: Sequence[complex]) -> list[complex]:
    chain: list[complex] = []
    for point in points:
        while len(chain) > 1 and cross(chain[-1] - chain[-2], point - chain[-1]) <= 0.0:
            chain.pop()
        chain.append(point)
    return chain


def box(points: Iterable[complex]) -> Box:
    """Return the smallest axis-aligned rectangle around points."""
    point_list = list(points)
    across, up = [p.real for p in point_list], [p.imag for p in point_list]
    return min(across), min(up), max(across), max(up)


def rectangle(center: complex, width: float, height: float, along: complex = RIGHT) -> Polygon:
    """Return the corners of a rectangle whose width lies along a unit vector."""
    half, up = 0.5 * width * along, 0.5 * height * along * 1j
    return (center - half - up, center + half - up, center + half + up, center - half + up)


def ring(center: complex, radius: float) -> Polygon:
    """Return an octagon around a circle."""
    corner = radius * 1.0824 * complex(0.92388, 0.38268)  # its sides touch the circle
    return tuple(center + corner * (0.70710678 + 0.70710678j) ** k for k in range(8))


def depth(one: Polygon, other: Polygon) -> float:
    """Return the penetration depth of two convex polygons; negative or zero if they are separate."""
    overlap = float("inf")
    for polygon in (one, other):
        for a, b in pairwise((*polygon, polygon[0])):
            if a == b:
                continue
            axis = 1j * unit_vector(b - a)
            mine, yours = [dot(axis, p) for p in one], [dot(axis, p) for p in other]
            overlap = min(overlap, max(mine) - min(yours), max(yours) - min(mine))
            if overlap <= 0.0:
                return overlap
    return overlap


def inside(point: complex, polygon: Polygon) -> bool:
    """Return whether a point lies in a polygon, convex or not."""
    is_inside = False
    for a, b in pairwise((*polygon, polygon[0])):
        if (a.imag > point.imag) != (b.imag > point.imag):
            is_inside ^= point.real < a.real + (point.imag - a.imag) * (b.real - a.real) / (b.imag - a.imag)
    return is_inside


def segment_distance(point: complex, a: complex, b: complex) -> float:
    """Return the distance of a point from the segment from `a` to `b`."""
    direction = unit_vector(b - a)
    return abs(point - a - min(max(dot(point - a, direction), 0.0), abs(b - a)) * direction)


def crosses(a: complex, b: complex, c: complex, d: complex) -> bool:
    """Return whether two segments, from `a` to `b` and from `c` to `d`, meet."""
    return (cross(b - a, c - a) * cross(b - a, d - a) < 0.0) and (cross(d - c, a - c) * cross(d - c, b - c) < 0.0)


def overlap_area(one: Box, other: Box) -> float:
    """Return the area that two boxes share."""
    width = min(one[2], other[2]) - max(one[0], other[0])
    height = min(one[3], other[3]) - max(one[1], other[1])
    return width * height if width > 0.0 and height > 0.0 else 0.0


def length_inside(a: complex, b: complex, area: Box) -> float:
    """Return the length of the part of a segment inside a box."""
    enter, leave, displacement = 0.0, 1.0, b - a
    for start, step, low, high in (
        (a.real, displacement.real, area[0], area[2]),
        (a.imag, displacement.imag, area[1], area[3]),
    ):
        if step == 0.0:
            if not low < start < high:
                return 0.0
            continue
        near, far = sorted(((low - start) / step, (high - start) / step))
        enter, leave = max(enter, near), min(leave, far)
    return max(0.0, leave - enter) * abs(displacement)


ZERO_TOL = 1e-9
SPAN, FROM_ABOVE = 5.0, 6.5  # units of the larger side of a drawing, seen from the front and from above
MAX_SPAN = 13.0  # units that this may grow to, so that neighbours do not overlap
NEIGHBOUR_GAP, COILED = 1.7, 2.4  # units between neighbours, and between bodies joined by springs
MAX_BODY_WIDTH = 2.6  # units across the largest body


@dataclass(frozen=True, slots=True)
class View:
    """A parallel projection to the page; `scale` is the number of drawing units per unit of length in the scene."""

    right: Vector
    up: Vector
    scale: float

    def project_direction(self, vector: Vector) -> complex:
        """Return the projection of a direction to the page; shorter than 1 if it points out of the page."""
        return complex(inner(self.right, vector), inner(self.up, vector))

    def at(self, place: Vector) -> complex:
        """Return the projection of a position to the page."""
        return self.scale * self.project_direction(place)

    @property
    def level(self) -> bool:
        """Return whether the scene is seen from above."""
        return abs(self.up[2]) < 1.0 - ZERO_TOL and abs(self.up[1]) > ZERO_TOL

    @property
    def page_normal(self) -> Vector:
        """Return the unit vector out of the page."""
        return outer(self.right, self.up)


def sides(mechanism: Mechanism, members: Sequence[RigidBody]) -> tuple[Vector, Vector]:
    """Return the world directions of right and up on the page: front view, or top view for motion in depth."""
    names = {body.name for body in members}
    thrust = next((burn.direction for burn in mechanism.burns if burn.body in names), None)
    if thrust is not None:
        aside = X if abs(thrust[0]) < 0.9 else scale(-1.0, Y)
        return unit(add(aside, scale(-inner(aside, thrust), thrust))), thrust
    coordinates = [c for body in members for c in body.coordinates]
    slides = [c.axis for c in coordinates if c.kind == "slide"]
    axles = [c.axis for c in coordinates if c.kind == "hinge"]
    away = next((axis for axis in slides if abs(axis[1]) > ZERO_TOL), None)
    if away is None and any(abs(axis[2]) > 1.0 - ZERO_TOL for axis in axles):
        away = Y
    if away is not None:
        up = unit((0.0, away[1], away[2]))
        up = up if up[1] > 0.0 else scale(-1.0, up)
        if all(abs(inner(outer(X, up), axis)) < ZERO_TOL for axis in slides):
            return X, up
    if away is None and axles and all(abs(axis[0]) > 1.0 - ZERO_TOL for axis in axles):
        return Y, Z
    return X, Z


def fitting(
    places: Iterable[complex], bodies: Sequence[complex], largest: float, wanted: float, *, apart: float
) -> float:
    """Return the scale, in units per unit of length, at which `places` span about `wanted` units.

    Small `bodies` keep `apart` if they can; `largest` is the width of the largest one.
    """
    left, low, right, high = box(places)
    span = max(right - left, high - low)
    if span < ZERO_TOL:
        return MAX_BODY_WIDTH / largest if largest else 1.0
    found = wanted / span
    nearest = min((abs(a - b) for a, b in combinations(bodies, 2) if abs(a - b) > 1e-3 * span), default=0.0)
    if nearest:
        found = max(found, min(apart / nearest, MAX_SPAN / span))
    return min(found, MAX_BODY_WIDTH / largest) if largest else found
