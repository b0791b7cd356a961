"""Bodies that slide, and regular prisms, which may also tumble."""

from collections.abc import Mapping
from math import cos, pi, sin
from typing import Annotated, Literal

from annotated_types import Ge, Le

from sim2reason.scenes.dsl.body import Axial, Body, Small, Tabletop, body
from sim2reason.scenes.dsl.measures import Coordinate, Mass, Measure, Range, Velocity
from sim2reason.scenes.dsl.solids import Extent, Overlooked, Radius, Shape, Solid, polygon, prism, rod
from sim2reason.scenes.dsl.template import Word
from sim2reason.scenes.dsl.vectors import Vector, add, scale


@body
class Block(Body):
    """A small block, moving without turning."""

    mass: Mass

    nouns = ("block", "crate")
    lone = ("a {noun} of mass {mass}", "a {noun} ({mass})", "a {noun} whose mass is {mass}")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")
    listed = "{letter} ({mass})"

    @property
    def look(self) -> Small:
        """Return the drawn shape: a rectangle."""
        return Small("block")


@body
class Carriage(Body):
    """Something small that a straight rail carries and guides."""

    mass: Mass

    nouns = ("carriage", "slider", "trolley")
    letters = "XYZ"
    lone = ("a {noun} of mass {mass}", "a {noun} ({mass})")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")
    symbols = {"mass": "M"}

    @property
    def look(self) -> Small:
        """Return the drawn shape: a box on wheels."""
        return Small("cart")


@body
class Cart(Body):
    """A small cart that a track leads along a straight line."""

    mass: Mass

    nouns = ("cart", "trolley", "block")
    lone = ("a {noun} of mass {mass}", "a {noun} ({mass})", "a {noun} whose mass is {mass}")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")
    listed = "{letter} ({mass})"
    alike = "({mass} each)"

    @property
    def look(self) -> Small:
        """Return the drawn shape: a cart."""
        return Small("cart")


@body
class Glider(Body):
    """A small body on a straight track; its place and velocity are counted to the right, or up the slope."""

    mass: Mass
    x: Coordinate
    v: Velocity

    nouns = ("block", "cart", "puck")
    words = {"moving": Word("v", {0.0: "at rest"}, "moving with velocity {v}")}
    lone = ("a {noun} of mass {mass}", "a {noun} ({mass})")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")
    listed = "{letter} ({mass})"

    @property
    def look(self) -> Small:
        """Return the drawn shape: a block."""
        return Small("block")


@body
class SlidingBall(Glider):
    """A small ball that slides along a straight smooth track, without turning."""

    nouns = ("ball", "sphere")

    @property
    def look(self) -> Small:
        """Return the drawn shape: a circle as high as a block."""
        return Small("sphere")


YCoordinate = Annotated[float, Ge(-1e3), Le(1e3), Measure("position", "m", "y", decimals=2), Range(-2.0, 2.0)]


@body
class Puck(Body):
    """A smooth round body on a table, with its place and velocity at the start."""

    mass: Mass
    x: Coordinate
    y: YCoordinate
    vx: Velocity
    vy: Velocity

    nouns = ("puck", "disc")
    lone = ("a {noun} of mass {mass}", "a {noun} ({mass})")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")
    listed = "{letter} ({mass})"
    symbols = {"vx": "v_x", "vy": "v_y"}
    words = {
        "moving": Word("vx", {0.0: "{moving_across}"}, "with velocity ({vx}, {vy})"),
        "moving_across": Word("vy", {0.0: "at rest"}, "with velocity (0 m/s, {vy})"),
        "motion": Word("vx", {0.0: "{motion_across}"}, "moving with velocity ({vx}, {vy})"),
        "motion_across": Word("vy", {0.0: "at rest"}, "moving with velocity (0 m/s, {vy})"),
    }

    @property
    def look(self) -> Small:
        """Return the drawn shape: a circle."""
        return Small("puck")


@body
class Table(Body):
    """A smooth table, level or tilted."""

    angle: Annotated[float, Ge(0), Le(85), Measure("angle", "deg", r"\theta", decimals=0), Range(0.0, 70.0)] = 0.0

    nouns = ("table",)
    letters = ""
    lone = ("a smooth {lie}", "a frictionless {lie}")
    words = {
        "lie": Word("angle", {0.0: "horizontal table"}, "table tilted at {angle} to the horizontal"),
        "axes": Word(
            "angle",
            {0.0: "x points to the right and y away from you"},
            "x points horizontally to the right and y straight up the slope",
        ),
    }

    @property
    def look(self) -> Tabletop:
        """Return the drawn shape: a sheet seen from above."""
        return Tabletop(self.angle)


@body
class Slab(Body):
    """A long flat block, moving without turning."""

    mass: Mass

    nouns = ("slab", "plank", "board")
    lone = ("a long {noun} of mass {mass}", "a long {noun} ({mass})")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")
    listed = "{letter} ({mass})"

    @property
    def look(self) -> Small:
        """Return the drawn shape: a flat rectangle, longer than the bodies on it."""
        return Small("slab")


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
