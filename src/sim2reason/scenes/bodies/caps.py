"""Hemispheres, caps and bowls."""

from typing import Annotated, Self

from annotated_types import Le
from pydantic import model_validator

from sim2reason.scenes.dsl.body import Capped, body
from sim2reason.scenes.dsl.measures import LEAST, Measure, Range
from sim2reason.scenes.dsl.solids import Radius, Shape, Solid, Thickness, segment
from sim2reason.scenes.dsl.template import Word

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
    named = (
        "a solid spherical {noun} {letter} of height {height} and mass {mass} cut from a uniform ball of radius {radius}",
        "a uniform spherical {noun} {letter} (height {height}, mass {mass}) sliced off a solid ball of radius {radius}",
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
    named = (
        "a {noun} {letter} of mass {mass} and height {height} cut from a uniform hollow sphere of outer radius {radius} and wall thickness {thickness}",
        "a {noun} {letter} ({height} high, mass {mass}) that is part of a uniform hollow sphere of outer radius {radius} and wall thickness {thickness}",
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
