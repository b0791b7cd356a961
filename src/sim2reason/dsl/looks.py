"""How bodies look in a drawing: a few kinds of look, of which the class of a body declares one.

Lengths are those of the text, in a body's own axes: z is the axis of what is round about one, and points to the pole
of a cap or to the hole of what has a hole.
"""

from dataclasses import dataclass
from math import hypot, sqrt
from typing import Literal

from sim2reason.dsl.vectors import Vector

SmallKind = Literal["ball", "sphere", "block", "slab", "cart", "puck", "rocket", "star", "planet"]
LineKind = Literal["string", "spring", "rod"]
THIN = 0.06  # the wall of what is thin, as it is drawn, as a part of its radius


@dataclass(frozen=True, slots=True)
class Small:
    """Something whose size does not matter; `mark` stands inside it, such as the sign of a charge."""

    kind: SmallKind
    mark: str = ""


@dataclass(frozen=True, slots=True)
class Spherical:
    """A sphere; a wall thickness makes it hollow, a hole has its centre at z = `offset`."""

    radius: float
    wall: float = 0.0
    hole: float = 0.0
    offset: float = 0.0

    def reach(self, way: Vector) -> float:
        """How far it extends along a unit vector, m."""
        del way
        return self.radius


@dataclass(frozen=True, slots=True)
class Axial:
    """A cylinder about z, or a prism if `sides` is given; a hole is parallel to z, with its axis at x = `offset`.

    Without a height the shape is a ring or a disc, without a radius a rod. A `step` is the radius of a drum on the end.
    """

    radius: float
    height: float = 0.0
    wall: float = 0.0
    sides: int = 0  # 0: round
    hole: float = 0.0
    offset: float = 0.0
    step: float = 0.0

    def reach(self, way: Vector) -> float:
        """How far it, or the cylinder about its edges, extends along a unit vector, m."""
        return self.radius * hypot(way[0], way[1]) + 0.5 * self.height * abs(way[2])


@dataclass(frozen=True, slots=True)
class Capped:
    """A part of a ball cut off at z = 0, with its pole at z = `height`; a wall thickness makes it a bowl."""

    radius: float
    height: float
    wall: float = 0.0

    def reach(self, way: Vector) -> float:
        """How far it extends along a unit vector from the centre of its flat face, m."""
        center = self.height - self.radius  # of the sphere, along z
        if center + self.radius * way[2] >= 0.0:
            return center * way[2] + self.radius
        return sqrt(max(0.0, self.height * (2.0 * self.radius - self.height))) * hypot(way[0], way[1])


@dataclass(frozen=True, slots=True)
class Rectangular:
    """A bar with its edges along its own axes."""

    x: float
    y: float
    z: float

    def reach(self, way: Vector) -> float:
        """How far it extends along a unit vector: to its farthest corner, m."""
        return 0.5 * (self.x * abs(way[0]) + self.y * abs(way[1]) + self.z * abs(way[2]))


@dataclass(frozen=True, slots=True)
class Silhouette:
    """A closed outline in the plane of its own x and z axes."""

    points: tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class FixedPlane:
    """A plane fixed in the room, at so many degrees; it is as long as what lies on it needs."""

    angle: float


@dataclass(frozen=True, slots=True)
class MovingSlope:
    """A wedge or prism; its faces are those on which something lies."""


@dataclass(frozen=True, slots=True)
class BigBox:
    """A box on the floor that is large enough to carry others on its top and at its sides."""


@dataclass(frozen=True, slots=True)
class PulleyWheel:
    """A pulley; a fixed one is held by a bracket, one with mass is filled."""

    fixed: bool
    solid: bool


@dataclass(frozen=True, slots=True)
class Tabletop:
    """A table seen from above, on which bodies move; `tilt` in degrees."""

    tilt: float = 0.0


@dataclass(frozen=True, slots=True)
class Slender:
    """Something light between two points, drawn where the mechanism has a line or an arm."""

    kind: LineKind


@dataclass(frozen=True, slots=True)
class Globe:
    """A planet so large that only its surface is seen, below what stands on it."""


@dataclass(frozen=True, slots=True)
class Unseen:
    """Nothing to be drawn at a place of its own: the region of a field, a way to start."""


BodyLook = (
    Small
    | Spherical
    | Axial
    | Capped
    | Rectangular
    | Silhouette
    | FixedPlane
    | MovingSlope
    | BigBox
    | PulleyWheel
    | Tabletop
    | Slender
    | Globe
    | Unseen
)
