"""A thin uniform rod."""

from typing import Annotated

from sim2reason.dsl.body import body
from sim2reason.dsl.looks import Axial
from sim2reason.dsl.measures import Length, Range
from sim2reason.dsl.shape import Shape
from sim2reason.dsl.solids import Solid, rod
from sim2reason.dsl.template import Word


@body
class UniformRod(Shape):
    """A uniform rod along z, so thin that only its length matters."""

    length: Annotated[Length, Range(0.2, 1.0)]

    nouns = ("rod",)
    words = {"axis": Word("mass", {}, "length")}
    lone = (
        "a uniform thin {noun} of length {length} and mass {mass}",
        "a thin uniform {noun} (length {length}, mass {mass})",
    )
    named = (
        "a uniform thin {noun} {letter} of length {length} and mass {mass}",
        "a thin uniform {noun} {letter} (length {length}, mass {mass})",
    )

    @property
    def solid(self) -> Solid:
        """About its centre."""
        return rod(self.length)

    @property
    def look(self) -> Axial:
        """A thick line."""
        return Axial(0.0, self.length)
