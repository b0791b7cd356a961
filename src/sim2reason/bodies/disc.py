"""A thin disc."""

from sim2reason.dsl.body import body
from sim2reason.dsl.looks import Axial
from sim2reason.dsl.shape import Radius, Shape
from sim2reason.dsl.solids import Solid
from sim2reason.dsl.solids import disc as thin_disc


@body
class Disc(Shape):
    """A uniform thin disc about z."""

    radius: Radius

    nouns = ("disc",)
    lone = (
        "a uniform thin {noun} of radius {radius} and mass {mass}",
        "a thin uniform {noun} of mass {mass} and radius {radius}",
    )
    named = (
        "a uniform thin {noun} {letter} of radius {radius} and mass {mass}",
        "a thin uniform {noun} {letter} (radius {radius}, mass {mass})",
    )

    @property
    def solid(self) -> Solid:
        """About its centre."""
        return thin_disc(self.radius)

    @property
    def look(self) -> Axial:
        """A disc, or a thick line from the side."""
        return Axial(self.radius)
