"""A solid hemisphere."""

from sim2reason.dsl.body import body
from sim2reason.dsl.looks import Capped
from sim2reason.dsl.shape import Radius, Shape
from sim2reason.dsl.solids import Solid, segment
from sim2reason.dsl.template import Word


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
        """About the centre of its flat face."""
        return segment(self.radius, self.radius)

    @property
    def look(self) -> Capped:
        """Half a disc."""
        return Capped(self.radius, self.radius)
