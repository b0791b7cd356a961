"""Regular prisms: of a stated height, or long ones that tumble and whose length never matters."""

from collections.abc import Mapping
from math import cos, pi, sin
from typing import Literal

from sim2reason.scenes.dsl.body import Axial, body
from sim2reason.scenes.dsl.solids import Extent, Overlooked, Radius, Shape, Solid, polygon, prism, rod
from sim2reason.scenes.dsl.vectors import Vector, add, scale

Polygon = Literal[
    "triangular", "square", "pentagonal", "hexagonal", "heptagonal", "octagonal", "decagonal", "dodecagonal"
]
SIDES: dict[str, int] = {
    "triangular": 3,
    "square": 4,
    "pentagonal": 5,
    "hexagonal": 6,
    "heptagonal": 7,
    "octagonal": 8,
    "decagonal": 10,
    "dodecagonal": 12,
}


@body
class PolygonalPrism(Shape):
    """A uniform prism about z; its cross-section is a regular polygon inscribed in a circle of `radius`."""

    shape: Polygon
    radius: Radius
    height: Extent

    bulky = True
    nouns = ("prism",)
    lone = (
        "a uniform regular {shape} {noun} of height {height} and mass {mass} with its lateral edges {radius} from its axis",
        "a uniform regular {shape} {noun} (height {height}, mass {mass}) whose lateral edges are {radius} from its axis",
    )
    named = (
        "a uniform regular {shape} {noun} {letter} of height {height} and mass {mass} with its lateral edges {radius} from its axis",
        "a uniform regular {shape} {noun} {letter} (height {height}, mass {mass}) whose lateral edges are {radius} from its axis",
    )

    @property
    def sides(self) -> int:
        """Return the number of sides of the cross-section."""
        return SIDES[self.shape]

    @property
    def solid(self) -> Solid:
        """Return the uniform mass distribution of the prism, with the centre as origin."""
        return prism(self.sides, self.radius, self.height)

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """Return the simplified mass distributions, by overlooked detail: a thin rod, and a thin plate."""
        return {"section": rod(self.height), "height": polygon(self.sides, self.radius)}

    @property
    def look(self) -> Axial:
        """Return the drawn shape: a rectangle from the side, a polygon from its end."""
        return Axial(self.radius, self.height, sides=self.sides)


@body
class LongPrism(Shape):
    """A uniform prism that only ever turns about its axis, z."""

    shape: Polygon
    radius: Radius

    nouns = ("prism",)
    lone = (
        "a long uniform {noun} of mass {mass} with a regular {shape} cross-section and its edges {radius} from its axis",
        "a long uniform regular {shape} {noun} of mass {mass} whose edges are {radius} from its axis",
    )
    named = (
        "a long uniform {noun} {letter} of mass {mass} with a regular {shape} cross-section and its edges {radius} from its axis",
        "a long uniform regular {shape} {noun} {letter} of mass {mass} whose edges are {radius} from its axis",
    )

    @property
    def sides(self) -> int:
        """Return the number of sides of the cross-section."""
        return SIDES[self.shape]

    @property
    def apothem(self) -> float:
        """Return the distance from the axis to the middle of a face, m."""
        return self.radius * cos(pi / self.sides)

    def edges(self, along: Vector, up: Vector) -> list[Vector]:
        """Return the vectors from the axis to the edges of a prism on a face, m, the front edge first."""
        turns = [(2 * number + 1) * pi / self.sides for number in range(self.sides)]
        return [add(scale(self.radius * sin(turn), along), scale(-self.radius * cos(turn), up)) for turn in turns]

    @property
    def solid(self) -> Solid:
        """Return the cross-section, since the length has no effect on rotation about the axis."""
        return polygon(self.sides, self.radius)

    @property
    def look(self) -> Axial:
        """Return the drawn shape: a polygon, seen from its end."""
        return Axial(self.radius, sides=self.sides)
