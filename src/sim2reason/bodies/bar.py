"""A rectangular bar."""

from collections.abc import Mapping
from typing import Annotated

from sim2reason.dsl.body import body
from sim2reason.dsl.looks import Rectangular
from sim2reason.dsl.measures import LEAST, Length, Measure, Range
from sim2reason.dsl.shape import SMALL, Overlooked, Shape
from sim2reason.dsl.solids import Solid, box, rod

Width = Annotated[float, LEAST, SMALL, Measure("width", "m", "w"), Range(0.05, 0.2)]
Depth = Annotated[float, LEAST, SMALL, Measure("thickness", "m", "h"), Range(0.02, 0.05)]


@body
class Bar(Shape):
    """A uniform rectangular bar: its width along x, its thickness along y, its length along z."""

    length: Annotated[Length, Range(0.2, 0.8)]
    width: Width
    thickness: Depth

    bulky = True
    nouns = ("bar",)
    lone = (
        "a uniform rectangular {noun} of length {length}, width {width}, thickness {thickness} and mass {mass}",
        "a rectangular {noun} of mass {mass} ({length} long, {width} wide, {thickness} thick)",
    )
    named = (
        "a uniform rectangular {noun} {letter} of length {length}, width {width}, thickness {thickness} and mass {mass}",
        "a rectangular {noun} {letter} of mass {mass} ({length} long, {width} wide, {thickness} thick)",
    )

    @property
    def solid(self) -> Solid:
        """About its centre."""
        return box(self.width, self.thickness, self.length)

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """A thin rod."""
        return {"section": rod(self.length)}

    @property
    def look(self) -> Rectangular:
        """A rectangle."""
        return Rectangular(self.width, self.thickness, self.length)
