"""Solid cylinders: of a stated height, or rollers whose length never matters."""

from collections.abc import Mapping

from sim2reason.dsl.body import body
from sim2reason.dsl.looks import Axial
from sim2reason.dsl.shape import Extent, Overlooked, Radius, Shape
from sim2reason.dsl.solids import Solid, cylinder, disc, rod


@body
class Cylinder(Shape):
    """A uniform solid cylinder about z."""

    radius: Radius
    height: Extent

    bulky = True
    nouns = ("cylinder",)
    lone = (
        "a uniform solid {noun} of radius {radius}, height {height} and mass {mass}",
        "a solid uniform {noun} of mass {mass} with a radius of {radius} and a height of {height}",
    )
    named = (
        "a uniform solid {noun} {letter} of radius {radius}, height {height} and mass {mass}",
        "a solid uniform {noun} {letter} (radius {radius}, height {height}, mass {mass})",
    )

    @property
    def solid(self) -> Solid:
        """About its centre."""
        return cylinder(self.radius, self.height)

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """A thin rod, and a thin disc."""
        return {"section": rod(self.height), "height": disc(self.radius)}

    @property
    def look(self) -> Axial:
        """A rectangle from the side, a disc from its end."""
        return Axial(self.radius, self.height)


@body
class Roller(Shape):
    """A uniform solid cylinder that only ever turns about its own axis, z."""

    radius: Radius

    nouns = ("cylinder", "roller")
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
        """As a disc: its length does not change how it turns about its axis."""
        return disc(self.radius)

    @property
    def look(self) -> Axial:
        """A disc: it is seen from its end."""
        return Axial(self.radius)
