"""Pipes: hollow cylinders that roll, with a thin wall or a thick one."""

from collections.abc import Mapping
from typing import Annotated, Self

from pydantic import model_validator

from sim2reason.dsl.body import body
from sim2reason.dsl.looks import THIN, Axial
from sim2reason.dsl.measures import LEAST, Measure, Range
from sim2reason.dsl.shape import SMALL, Overlooked, Radius, Shape
from sim2reason.dsl.solids import Solid, disc, ring

Bore = Annotated[float, LEAST, SMALL, Measure("inner radius", "m", "r"), Range(0.02, 0.12)]


@body
class Pipe(Shape):
    """A pipe with a thin wall, about z; its length never matters."""

    radius: Radius

    nouns = ("pipe", "tube")
    lone = (
        "a thin-walled {noun} of radius {radius} and mass {mass}",
        "a thin-walled {noun} of mass {mass} and radius {radius}",
    )
    named = (
        "a thin-walled {noun} {letter} of radius {radius} and mass {mass}",
        "a thin-walled {noun} {letter} (radius {radius}, mass {mass})",
    )

    @property
    def solid(self) -> Solid:
        """As a ring: its length does not change how it turns about its axis."""
        return ring(self.radius)

    @property
    def look(self) -> Axial:
        """A ring: it is seen from its end."""
        return Axial(self.radius, wall=THIN * self.radius)


@body
class ThickPipe(Shape):
    """A pipe with a thick wall, about z; its length never matters."""

    radius: Annotated[Radius, Range(0.08, 0.2)]
    bore: Bore

    nouns = ("pipe", "tube")
    lone = (
        "a thick-walled {noun} of outer radius {radius}, inner radius {bore} and mass {mass}",
        "a {noun} of mass {mass} with an outer radius of {radius} and an inner radius of {bore}",
    )
    named = (
        "a thick-walled {noun} {letter} of outer radius {radius}, inner radius {bore} and mass {mass}",
        "a thick-walled {noun} {letter} (outer radius {radius}, inner radius {bore}, mass {mass})",
    )

    @model_validator(mode="after")
    def _has_a_wall(self) -> Self:
        if self.bore >= self.radius:
            raise ValueError("bore: the inner radius is not less than the outer one; make it smaller")
        return self

    @property
    def solid(self) -> Solid:
        """A disc less its middle: its length does not change how it turns about its axis."""
        return disc(self.radius) - disc(self.bore)

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """A thin pipe."""
        return {"wall": ring(self.radius)}

    @property
    def look(self) -> Axial:
        """A broad ring: it is seen from its end."""
        return Axial(self.radius, wall=self.radius - self.bore)
