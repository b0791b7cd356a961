"""Bodies that slide."""

from typing import Annotated

from annotated_types import Ge, Le

from sim2reason.scenes.dsl.body import Body, Small, Tabletop, body
from sim2reason.scenes.dsl.measures import Coordinate, Mass, Measure, Range, Velocity
from sim2reason.scenes.dsl.template import Word


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
