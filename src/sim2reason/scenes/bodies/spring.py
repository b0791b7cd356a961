"""Light springs."""

from typing import Annotated

from annotated_types import Ge, Le

from sim2reason.scenes.dsl.body import Body, Slender, body
from sim2reason.scenes.dsl.measures import Measure, NaturalLength, Range, Stiffness


@body
class Spring(Body):
    """A light spring that obeys Hooke's law, stretched or compressed; several of them are numbered."""

    stiffness: Stiffness
    length: NaturalLength

    nouns = ("spring",)
    letters = "123456789"
    lone = (
        "a light {noun} of stiffness {stiffness} and natural length {length}",
        "a light {noun} (stiffness {stiffness}, natural length {length})",
        "a light {noun} with a stiffness of {stiffness} and a natural length of {length}",
    )
    named = (
        "light {noun} {letter} of stiffness {stiffness} and natural length {length}",
        "light {noun} {letter} (stiffness {stiffness}, natural length {length})",
    )
    listed = "{letter} (stiffness {stiffness}, natural length {length})"
    alike = "(each of stiffness {stiffness} and natural length {length})"

    @property
    def look(self) -> Slender:
        """Return the drawn shape: a coil."""
        return Slender("spring")


@body
class Coil(Body):
    """A light spring whose natural length does not matter, since only its extension is spoken of."""

    stiffness: Stiffness

    nouns = ("spring",)
    letters = "123456789"
    lone = ("a light {noun} of stiffness {stiffness}", "a light {noun} ({stiffness})")
    named = ("light {noun} {letter} of stiffness {stiffness}", "light {noun} {letter} ({stiffness})")
    listed = "{letter} ({stiffness})"
    alike = "({stiffness} each)"

    @property
    def look(self) -> Slender:
        """Return the drawn shape: a coil."""
        return Slender("spring")


@body
class NailedSpring(Spring):
    """A light spring on a table, one end of which is fixed at a point."""

    x: Annotated[float, Ge(-1e3), Le(1e3), Measure("fixed end", "m", "x", decimals=2), Range(-0.9, 0.9)]
    y: Annotated[float, Ge(-1e3), Le(1e3), Measure("fixed end", "m", "y", decimals=2), Range(-0.9, 0.9)]


@body
class Bumper(Body):
    """A light spring on the front of something: it pushes what comes nearer than its natural length."""

    stiffness: Stiffness
    length: Annotated[NaturalLength, Range(0.1, 0.4)]

    nouns = ("spring buffer", "buffer spring")
    letters = "123456789"
    lone = (
        "a light {noun} of stiffness {stiffness} and natural length {length}",
        "a light {noun} (stiffness {stiffness}, natural length {length})",
    )
    named = (
        "light {noun} {letter} of stiffness {stiffness} and natural length {length}",
        "light {noun} {letter} (stiffness {stiffness}, natural length {length})",
    )
    listed = "{letter} (stiffness {stiffness}, natural length {length})"

    @property
    def look(self) -> Slender:
        """Return the drawn shape: a coil."""
        return Slender("spring")
