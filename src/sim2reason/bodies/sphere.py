"""A solid sphere."""

from sim2reason.dsl.body import body
from sim2reason.dsl.looks import Spherical
from sim2reason.dsl.shape import Radius, Shape
from sim2reason.dsl.solids import Solid, ball


@body
class Sphere(Shape):
    """A uniform solid sphere."""

    radius: Radius

    bulky = True
    nouns = ("sphere",)
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
        """About its centre."""
        return ball(self.radius)

    @property
    def look(self) -> Spherical:
        """A disc."""
        return Spherical(self.radius)
