"""Round bodies with the centre of mass off their axis: bodies with a hole, hemispheres, caps and bowls."""

from collections.abc import Mapping
from math import hypot
from typing import Annotated, ClassVar, Self

from annotated_types import Le
from pydantic import model_validator

from sim2reason.scenes.dsl.body import Axial, Capped, Spherical, body
from sim2reason.scenes.dsl.measures import LEAST, Measure, Range
from sim2reason.scenes.dsl.mechanism import X, Y, Z
from sim2reason.scenes.dsl.solids import (
    Axes,
    HoleOffset,
    HoleRadius,
    Overlooked,
    Radius,
    Shape,
    Solid,
    Thickness,
    ball,
    disc,
    lens,
    segment,
)
from sim2reason.scenes.dsl.template import Word
from sim2reason.scenes.dsl.vectors import Vector


@body
class BoredCylinder(Shape):
    """A cylinder about y with a round hole whose axis lies beside its own, towards z; its length never matters."""

    radius: Annotated[Radius, Range(0.1, 0.2)]
    hole: HoleRadius
    offset: HoleOffset

    seen: ClassVar[Axes] = (Z, X, Y)
    nouns = ("cylinder", "roller")
    lone = (
        "a bored {noun} of mass {mass} and radius {radius} whose round hole of radius {hole} runs along its whole length at {offset} from its axis",
        "a uniform solid {noun} of radius {radius} with a hole of radius {hole} bored along its whole length at {offset} from its axis (mass after boring: {mass})",
    )

    @model_validator(mode="after")
    def _encloses_the_hole(self) -> Self:
        if self.hole + self.offset >= self.radius:
            raise ValueError("hole, offset: the hole breaks through; give less than the radius in all")
        return self

    @property
    def solid(self) -> Solid:
        """Return a disc minus its hole, since the length has no effect on rotation about the axis."""
        return (disc(self.radius) - disc(self.hole).moved((self.offset, 0.0, 0.0))).turned(self.seen)

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """Return the simplified mass distributions, by overlooked detail: a full disc, which ignores the hole."""
        return {"hole": disc(self.radius).turned(self.seen)}

    @property
    def look(self) -> Axial:
        """Return the drawn shape: a disc with its hole."""
        return Axial(self.radius, hole=self.hole, offset=self.offset)

    def reach(self, way: Vector) -> float:
        """Return the distance to the surface along a unit vector, m."""
        return self.radius * hypot(way[0], way[2])


@body
class SphereWithHole(Shape):
    """A sphere with a spherical hole inside it; z points from its centre to the hole's."""

    radius: Annotated[Radius, Range(0.08, 0.15)]
    hole: HoleRadius
    offset: HoleOffset

    bulky = True
    nouns = ("sphere",)
    words = {"gap": Word("mass", {}, "hole")}
    lone = (
        "a {noun} of mass {mass} and radius {radius}, uniform but for a spherical hole of radius {hole} centred {offset} from the centre of the {noun}",
        "a uniform {noun} of radius {radius} with a spherical hole of radius {hole} whose centre lies {offset} from that of the {noun} (mass with the hole: {mass})",
    )

    @model_validator(mode="after")
    def _encloses_the_hole(self) -> Self:
        if self.hole + self.offset >= self.radius:
            raise ValueError("hole, offset: the hole breaks through; give less than the radius in all")
        return self

    @property
    def solid(self) -> Solid:
        """Return the ball minus its hole, with the ball's centre as origin."""
        return ball(self.radius) - ball(self.hole).moved((0.0, 0.0, self.offset))

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """Return the simplified mass distributions, by overlooked detail: a full ball, which ignores the hole."""
        return {"hole": ball(self.radius)}

    @property
    def look(self) -> Spherical:
        """Return the drawn shape: a disc with its hole, as if cut open."""
        return Spherical(self.radius, hole=self.hole, offset=self.offset)


@body
class HollowSphereWithHole(Shape):
    """A hollow sphere of whose wall a ball about a point off its centre is cut away; z points to that point."""

    radius: Annotated[Radius, Range(0.08, 0.15)]
    thickness: Annotated[Thickness, Range(0.01, 0.02)]
    hole: Annotated[HoleRadius, Range(0.03, 0.07)]
    offset: Annotated[HoleOffset, Range(0.08, 0.15)]

    bulky = True
    nouns = ("sphere",)
    words = {"gap": Word("mass", {}, "opening")}
    lone = (
        "a hollow {noun} of mass {mass}, outer radius {radius} and wall thickness {thickness} whose wall is missing within {hole} of a point {offset} from its centre",
        "a hollow {noun} (outer radius {radius}, wall thickness {thickness}, mass {mass}) whose wall has an opening cut by a ball of radius {hole} centred {offset} from its centre",
    )

    @model_validator(mode="after")
    def _is_cut(self) -> Self:
        if self.thickness >= self.radius:
            raise ValueError("thickness: the wall is thicker than the sphere; give less than its radius")
        if not abs(self.radius - self.offset) < self.hole < self.offset:
            raise ValueError("hole, offset: it must cut through the wall and leave the centre out")
        if self.offset - self.hole >= self.radius - self.thickness:
            raise ValueError("hole, offset: the cut does not reach the cavity; make it larger")
        return self

    @property
    def solid(self) -> Solid:
        """Return the spherical wall minus its opening, with the sphere's centre as origin."""
        inner = self.radius - self.thickness
        cut = lens(self.radius, self.hole, self.offset) - lens(inner, self.hole, self.offset)
        return ball(self.radius) - ball(inner) - cut

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """Return the simplified mass distributions, by overlooked detail: a hollow sphere without the opening."""
        return {"hole": ball(self.radius) - ball(self.radius - self.thickness)}

    @property
    def look(self) -> Spherical:
        """Return the drawn shape: a ring with its opening, as if cut open."""
        return Spherical(self.radius, wall=self.thickness, hole=self.hole, offset=self.offset)


CutHeight = Annotated[float, LEAST, Le(2e2), Measure("height", "m", "h"), Range(0.04, 0.2)]


@body
class SphericalCap(Shape):
    """A solid part of a ball: the centre of its flat face is the origin, its pole lies towards z."""

    radius: Radius
    height: CutHeight

    bulky = True
    nouns = ("cap",)
    words = {"front": Word("mass", {}, "flat face")}
    lone = (
        "a solid spherical {noun} of height {height} and mass {mass} cut from a uniform ball of radius {radius}",
        "a uniform spherical {noun} (height {height}, mass {mass}) sliced off a solid ball of radius {radius}",
    )

    @model_validator(mode="after")
    def _is_cut(self) -> Self:
        if self.height >= 2.0 * self.radius:
            raise ValueError("height: nothing is cut off; give less than the ball's diameter")
        return self

    @property
    def solid(self) -> Solid:
        """Return the uniform mass distribution of the cap, with the centre of the flat face as origin."""
        return segment(self.radius, self.height)

    @property
    def look(self) -> Capped:
        """Return the drawn shape: a segment of a circle."""
        return Capped(self.radius, self.height)


@body
class Bowl(Shape):
    """A hollow part of a sphere: the centre of its opening is the origin, its lowest point lies towards z."""

    radius: Radius
    height: CutHeight
    thickness: Thickness

    bulky = True
    nouns = ("bowl",)
    words = {"front": Word("mass", {}, "opening")}
    lone = (
        "a {noun} of mass {mass} and height {height} cut from a uniform hollow sphere of outer radius {radius} and wall thickness {thickness}",
        "a {noun} ({height} high, mass {mass}) that is part of a uniform hollow sphere of outer radius {radius} and wall thickness {thickness}",
    )

    @model_validator(mode="after")
    def _is_cut(self) -> Self:
        if self.thickness >= min(self.radius, self.height):
            raise ValueError("thickness: the wall is as thick as the bowl; make it thinner")
        if self.height >= 2.0 * self.radius - self.thickness:
            raise ValueError("height: the bowl has no opening; give less than the inner diameter and the wall")
        return self

    @property
    def solid(self) -> Solid:
        """Return the mass distribution, the difference of two caps, with the centre of the opening as origin."""
        return segment(self.radius, self.height) - segment(self.radius - self.thickness, self.height - self.thickness)

    @property
    def look(self) -> Capped:
        """Return the drawn shape: a curved wall."""
        return Capped(self.radius, self.height, self.thickness)


@body
class Hemisphere(Shape):
    """A uniform solid hemisphere: the centre of its flat face is the origin, its pole lies towards z."""

    radius: Radius

    bulky = True
    nouns = ("hemisphere",)
    words = {"front": Word("mass", {}, "flat face")}
    lone = (
        "a uniform solid {noun} of radius {radius} and mass {mass}",
        "a solid uniform {noun} of mass {mass} and radius {radius}",
    )
    named = (
        "a uniform solid {noun} {letter} of radius {radius} and mass {mass}",
        "a solid uniform {noun} {letter} (radius {radius}, mass {mass})",
    )

    @property
    def solid(self) -> Solid:
        """Return the uniform mass distribution of the cap, with the centre of the flat face as origin."""
        return segment(self.radius, self.radius)

    @property
    def look(self) -> Capped:
        """Return the drawn shape: half a disc."""
        return Capped(self.radius, self.radius)
