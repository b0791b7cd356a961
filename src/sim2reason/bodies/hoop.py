"""A thin hoop."""

from sim2reason.dsl.body import body
from sim2reason.dsl.looks import THIN, Axial
from sim2reason.dsl.shape import Radius, Shape
from sim2reason.dsl.solids import Solid, ring


@body
class Hoop(Shape):
    """A thin circular hoop about z."""

    radius: Radius

    nouns = ("hoop", "ring")
    lone = (
        "a thin {noun} of radius {radius} and mass {mass}",
        "a thin uniform {noun} of mass {mass} and radius {radius}",
    )
    named = (
        "a thin {noun} {letter} of radius {radius} and mass {mass}",
        "a thin uniform {noun} {letter} (radius {radius}, mass {mass})",
    )

    @property
    def solid(self) -> Solid:
        """About its centre."""
        return ring(self.radius)

    @property
    def look(self) -> Axial:
        """A ring."""
        return Axial(self.radius, wall=THIN * self.radius)
