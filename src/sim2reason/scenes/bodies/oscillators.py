"""Parts of oscillators: bobs, rods and arms of pendulums, and light springs."""

from collections.abc import Mapping
from typing import Annotated

from annotated_types import Ge, Le

from sim2reason.scenes.dsl.body import Axial, Body, Rectangular, Slender, Small, body
from sim2reason.scenes.dsl.measures import LEAST, Length, Mass, Measure, NaturalLength, Range, Stiffness
from sim2reason.scenes.dsl.solids import MAX_SIZE, Overlooked, Shape, Solid, box, point, rod
from sim2reason.scenes.dsl.template import Word
from sim2reason.scenes.dsl.vectors import Vector


@body
class Arm(Body):
    """A light straight arm, pivoted about an axle."""

    nouns = ("arm",)
    letters = "LMN"
    lone = ("a light straight {noun}", "a straight light {noun}")

    @property
    def look(self) -> Slender:
        """Return the drawn shape: a bar."""
        return Slender("rod")


MAX_BEAD_MASS = 0.3  # kg


@body
class Ball(Body):
    """A ball so small that its size never matters."""

    mass: Annotated[Mass, Range(0.05, 2.0)]

    nouns = ("ball", "bead")
    lone = ("a small {noun} of mass {mass}", "a small {noun} ({mass})")
    listed = "{letter} ({mass})"

    def suits(self, noun: str, bodies: Mapping[str, Body]) -> bool:
        """Return whether the ball is light enough for the noun *bead*; True for other nouns."""
        del bodies
        return noun != "bead" or self.mass <= MAX_BEAD_MASS

    @property
    def look(self) -> Small:
        """Return the drawn shape: a filled circle."""
        return Small("ball")


@body
class Bead(Ball):
    """A small ball that a ring or a wire leads."""

    nouns = ("bead",)
    alike = "({mass} each)"


@body
class FixedBall(Shape):
    """A ball that is fixed to something and so small that its own moment of inertia never matters."""

    nouns = ("ball",)
    lone = ("a small {noun} of mass {mass}", "a small {noun} ({mass})")

    @property
    def solid(self) -> Solid:
        """Return the mass distribution of the ball: a point."""
        return point()

    @property
    def look(self) -> Small:
        """Return the drawn shape: a filled circle."""
        return Small("ball")

    def reach(self, way: Vector) -> float:
        """Return zero, the extent of a point, m."""
        del way
        return 0.0


Width = Annotated[float, LEAST, MAX_SIZE, Measure("width", "m", "w"), Range(0.05, 0.2)]
Depth = Annotated[float, LEAST, MAX_SIZE, Measure("thickness", "m", "h"), Range(0.02, 0.05)]


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

    @property
    def solid(self) -> Solid:
        """Return the uniform mass distribution of the body, with the centre as origin."""
        return box(self.width, self.thickness, self.length)

    @property
    def plainer(self) -> Mapping[Overlooked, Solid]:
        """Return the simplified mass distributions, by overlooked detail: a thin rod."""
        return {"section": rod(self.length)}

    @property
    def look(self) -> Rectangular:
        """Return the drawn shape: a rectangle."""
        return Rectangular(self.width, self.thickness, self.length)


class Hanger(Body):
    """Base class of light suspensions of a stated length between a fixed point and a bob."""

    length: Length

    letters = ""


@body
class Cord(Hanger):
    """A light inextensible string."""

    nouns = ("string",)
    words = {"straight": Word("length", {}, "is taut and makes")}
    lone = ("a light inextensible {noun} of length {length}", "a light, inextensible {noun} of length {length}")

    @property
    def look(self) -> Slender:
        """Return the drawn shape: a thin line."""
        return Slender("string")


@body
class LightRod(Hanger):
    """A light rigid rod."""

    nouns = ("rod",)
    words = {"straight": Word("length", {}, "makes")}
    lone = ("a light rigid {noun} of length {length}", "a light, rigid {noun} of length {length}")

    @property
    def look(self) -> Slender:
        """Return the drawn shape: a bar."""
        return Slender("rod")


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

    @property
    def solid(self) -> Solid:
        """Return the uniform mass distribution of the body, with the centre as origin."""
        return rod(self.length)

    @property
    def look(self) -> Axial:
        """Return the drawn shape: a thick line."""
        return Axial(0.0, self.length)


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
