"""A cylinder with a hole bored along its whole length beside its axis."""

from collections.abc import Mapping
from math import hypot
from typing import Annotated, ClassVar, Self

from pydantic import model_validator

from sim2reason.dsl.body import body
from sim2reason.dsl.looks import Axial
from sim2reason.dsl.measures import Range
from sim2reason.dsl.mechanism import X, Y, Z
from sim2reason.dsl.shape import HoleOffset, HoleRadius, Overlooked, Radius, Shape
from sim2reason.dsl.solids import Axes, Solid, disc
from sim2reason.dsl.vectors import Vector


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
    named = (
        "a bored {noun} {letter} of mass {mass} and radius {radius} whose round hole of radius {hole} runs along its whole length at {offset} from its axis",
        "a uniform solid {noun} {letter} of radius {radius} with a hole of radius {hole} bored along its whole length at {offset} from its axis (mass after boring: {mass})",
    )

    @model_validator(mode="after")
    def _encloses_the_hole(self) -> Self:
        if self.hole + self.offset >= self.radius:
            raise ValueError("hole, offset: the hole breaks through; give less than the radius in all")
        return self

    @property
    def solid(self) -> Solid:
        """A disc less the hole: its length does not change how it turns about its axis."""
        return (disc(self.radius) - disc(self.hole).moved((self.offset, 0.0, 0.0))).turned(self.seen)

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """A disc without the hole."""
        return {"hole": disc(self.radius).turned(self.seen)}

    @property
    def look(self) -> Axial:
        """A disc with its hole."""
        return Axial(self.radius, hole=self.hole, offset=self.offset)

    def reach(self, way: Vector) -> float:
        """To its surface."""
        return self.radius * hypot(way[0], way[2])
