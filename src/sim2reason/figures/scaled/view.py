"""Projection of the world frame to the page: direction of view and scale."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from itertools import combinations

from sim2reason.figures.vectors import box
from sim2reason.scenes.dsl.mechanism import Mechanism, RigidBody, X, Y, Z
from sim2reason.scenes.dsl.vectors import Vector, add, inner, outer, scale, unit

SMALL = 1e-9
SPAN, FROM_ABOVE = 5.0, 6.5  # units of the larger side of a drawing, seen from the front and from above
MAX_SPAN = 13.0  # units that this may grow to, so that neighbours do not overlap
NEIGHBOUR_GAP, COILED = 1.7, 2.4  # units between neighbours, and between bodies joined by springs
LARGEST = 2.6  # units across the largest body


@dataclass(frozen=True, slots=True)
class View:
    """A parallel projection to the page; `scale` is the number of drawing units per unit of length in the scene."""

    right: Vector
    up: Vector
    scale: float

    def way(self, vector: Vector) -> complex:
        """Return the projection of a direction to the page; shorter than 1 if it points out of the page."""
        return complex(inner(self.right, vector), inner(self.up, vector))

    def at(self, place: Vector) -> complex:
        """Return the projection of a position to the page."""
        return self.scale * self.way(place)

    @property
    def level(self) -> bool:
        """Return whether the scene is seen from above."""
        return abs(self.up[2]) < 1.0 - SMALL and abs(self.up[1]) > SMALL

    @property
    def towards(self) -> Vector:
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
    away = next((axis for axis in slides if abs(axis[1]) > SMALL), None)
    if away is None and any(abs(axis[2]) > 1.0 - SMALL for axis in axles):
        away = Y
    if away is not None:
        up = unit((0.0, away[1], away[2]))
        up = up if up[1] > 0.0 else scale(-1.0, up)
        if all(abs(inner(outer(X, up), axis)) < SMALL for axis in slides):
            return X, up
    if away is None and axles and all(abs(axis[0]) > 1.0 - SMALL for axis in axles):
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
    if span < SMALL:
        return LARGEST / largest if largest else 1.0
    found = wanted / span
    nearest = min((abs(a - b) for a, b in combinations(bodies, 2) if abs(a - b) > 1e-3 * span), default=0.0)
    if nearest:
        found = max(found, min(apart / nearest, MAX_SPAN / span))
    return min(found, LARGEST / largest) if largest else found
