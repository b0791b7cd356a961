"""Charged beads, and regions of fields."""

from math import cos, hypot, inf, radians, sin
from typing import Annotated, Literal, Self

from annotated_types import Ge, Le, Lt
from pydantic import model_validator

from sim2reason.scenes.dsl.body import Body, Small, Unseen, body
from sim2reason.scenes.dsl.measures import LEAST, Measure, Range, Speed
from sim2reason.scenes.dsl.mechanism import X, Y
from sim2reason.scenes.dsl.template import Word
from sim2reason.scenes.dsl.vectors import BoxRegion, DiscRegion, HalfSpace, Region

BeadMass = Annotated[float, Ge(1e-26), Le(1e6), Measure("mass", "mg", "m"), Range(1.0, 5.0)]
Charge = Annotated[
    float, Ge(1e-14), Le(1e6), Measure("charge", "uC", "q", called="magnitude of the charge"), Range(1.0, 5.0)
]
Heading = Annotated[float, Ge(0), Lt(360), Measure("angle", "deg", r"\theta", decimals=0), Range(2.0, 358.0)]


@body
class ChargedBead(Body):
    """A small body with a charge."""

    mass: BeadMass
    charge: Charge
    sign: Literal["positive", "negative"]

    nouns = ("bead", "ball")
    words = {
        "charged": Word(
            "sign",
            {"positive": "a positive charge of {charge}", "negative": "a negative charge of magnitude {charge}"},
        ),
    }
    lone = (
        "a small {noun} of mass {mass} with {charged}",
        "a small {noun} ({mass}) that carries {charged}",
    )
    named = (
        "a small {noun} {letter} of mass {mass} with {charged}",
        "a small {noun} {letter} ({mass}), which carries {charged},",
    )

    @property
    def signed_charge(self) -> float:
        """Return the charge with its sign, uC."""
        return self.charge if self.sign == "positive" else -self.charge

    @property
    def look(self) -> Small:
        """Return the drawn shape: a filled circle with the sign of the charge."""
        return Small("ball", "+" if self.sign == "positive" else "\N{MINUS SIGN}")


class BeadStart(Body):
    """Base class of the initial motions of a bead at the origin, described by what the bead does there."""

    letters = ""

    @property
    def velocity(self) -> tuple[float, float]:
        """Return the velocity components along x and y, m/s."""
        raise NotImplementedError

    @property
    def look(self) -> Unseen:
        """Return the empty drawn shape, since the figure draws the velocity at the bead."""
        return Unseen()


@body
class Launched(BeadStart):
    """It has a velocity."""

    speed: Annotated[Speed, Range(1.5, 4.0)]
    angle: Heading

    nouns = ("start",)
    lone = (
        "leaves the origin of the x-y plane at speed {speed} {heading}",
        "is at the origin of the x-y plane, moving at speed {speed} {heading}",
    )
    words = {
        "heading": Word(
            "angle",
            {
                0.0: "in the positive x direction",
                90.0: "in the positive y direction",
                180.0: "in the negative x direction",
                270.0: "in the negative y direction",
            },
            "in a direction {angle} counter-clockwise from the positive x direction",
        ),
    }

    @property
    def velocity(self) -> tuple[float, float]:
        """Return the velocity components along x and y, m/s."""
        return self.speed * cos(radians(self.angle)), self.speed * sin(radians(self.angle))


@body
class Released(BeadStart):
    """It is let go."""

    nouns = ("start",)
    lone = (
        "is released from rest at the origin of the x-y plane",
        "starts from rest at the origin of the x-y plane",
    )

    @property
    def velocity(self) -> tuple[float, float]:
        """Return the zero velocity, m/s."""
        return 0.0, 0.0


Border = Annotated[float, Ge(-1e3), Le(1e3), Measure("position", "m", "x", decimals=2), Range(-2.0, 2.0)]
Radius = Annotated[float, LEAST, Le(1e3), Measure("radius", "m", "R", decimals=2), Range(0.3, 0.9)]
Near = Range(0.3, 1.0)
Far = Range(1.2, 2.5)


class FieldRegion(Body):
    """A region of the plane, outside which no field acts."""

    letters = ""

    @property
    def shape(self) -> Region:
        """Return the region about the origin of the plane."""
        raise NotImplementedError

    @property
    def middle(self) -> tuple[float, float]:
        """Return a point in the region at which a bead may be aimed, m."""
        raise NotImplementedError

    @property
    def width(self) -> float:
        """Return the length of the longest straight path through the region, m; infinite for an unbounded region."""
        raise NotImplementedError

    @property
    def look(self) -> Unseen:
        """Return the empty drawn shape, as the force draws the region."""
        return Unseen()


@body
class HalfPlane(FieldRegion):
    """All places to the right of a line."""

    edge: Annotated[Border, Near]

    nouns = ("half-plane",)
    lone = ("the {noun} x > {edge}", "the {noun} to the right of x = {edge}")

    @property
    def shape(self) -> Region:
        """Return the half-space that begins at the edge."""
        return HalfSpace(X, self.edge)

    @property
    def middle(self) -> tuple[float, float]:
        """Return a point a little beyond the edge, m."""
        return self.edge + 0.5, 0.0

    @property
    def width(self) -> float:
        """Return infinity, as the region is unbounded."""
        return inf


@body
class Strip(FieldRegion):
    """All places between two lines."""

    low: Annotated[Border, Near]
    high: Annotated[Border, Far]

    nouns = ("strip",)
    lone = ("the {noun} between x = {low} and x = {high}", "the {noun} from x = {low} to x = {high}")
    symbols = {"low": "x_1", "high": "x_2"}

    @model_validator(mode="after")
    def _has_width(self) -> Self:
        if self.low >= self.high:
            raise ValueError("high: it is not greater than low; make it greater")
        return self

    @property
    def shape(self) -> Region:
        """Return the slab, unbounded along y."""
        return BoxRegion(((X, self.low, self.high),))

    @property
    def middle(self) -> tuple[float, float]:
        """Return the point half-way between the lines, m."""
        return 0.5 * (self.low + self.high), 0.0

    @property
    def width(self) -> float:
        """Return the distance of the lines, m; paths along them do not cross the strip."""
        return self.high - self.low


@body
class Rectangle(FieldRegion):
    """A rectangle whose sides lie along the axes."""

    left: Annotated[Border, Near]
    bottom: Annotated[Border, Range(-1.5, -0.3)]
    right: Annotated[Border, Far]
    top: Annotated[Border, Range(0.3, 1.5)]

    nouns = ("rectangle",)
    lone = (
        "the {noun} with opposite corners ({left}, {bottom}) and ({right}, {top})",
        "the {noun} of which ({left}, {bottom}) and ({right}, {top}) are opposite corners",
    )
    symbols = {"left": "x_1", "bottom": "y_1", "right": "x_2", "top": "y_2"}

    @model_validator(mode="after")
    def _has_sides(self) -> Self:
        if self.left >= self.right or self.bottom >= self.top:
            raise ValueError("right, top: the second corner must lie to the right of the first, and above it")
        return self

    @property
    def shape(self) -> Region:
        """Return the box with four sides."""
        return BoxRegion(((X, self.left, self.right), (Y, self.bottom, self.top)))

    @property
    def middle(self) -> tuple[float, float]:
        """Return the centre, m."""
        return 0.5 * (self.left + self.right), 0.5 * (self.bottom + self.top)

    @property
    def width(self) -> float:
        """Return the diagonal, m."""
        return hypot(self.right - self.left, self.top - self.bottom)


@body
class CircularRegion(FieldRegion):
    """All places that are no farther than a radius from a point."""

    radius: Radius
    x: Annotated[Border, Range(0.5, 2.0)]
    y: Annotated[Border, Range(-1.0, 1.0)]

    nouns = ("circle",)
    lone = (
        "the {noun} of radius {radius} about the point ({x}, {y})",
        "the {noun} of radius {radius} with its centre at ({x}, {y})",
    )
    symbols = {"x": "x_0", "y": "y_0"}

    @property
    def shape(self) -> Region:
        """Return the cylinder whose axis is perpendicular to the plane."""
        return DiscRegion((self.x, self.y, 0.0), self.radius)

    @property
    def middle(self) -> tuple[float, float]:
        """Return the centre if it is not the origin, else a point of the border, m."""
        return (self.x, self.y) if hypot(self.x, self.y) else (self.radius, 0.0)

    @property
    def width(self) -> float:
        """Return the diameter, m."""
        return 2.0 * self.radius
