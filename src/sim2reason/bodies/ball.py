"""A small ball."""

from collections.abc import Mapping
from typing import Annotated

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import Small
from sim2reason.dsl.measures import Mass, Range
from sim2reason.dsl.shape import Shape
from sim2reason.dsl.solids import Solid, point
from sim2reason.dsl.vectors import Vector

HEAVIEST_BEAD = 0.3  # kg


@body
class Ball(Body):
    """A ball so small that its size never matters."""

    mass: Annotated[Mass, Range(0.05, 2.0)]

    nouns = ("ball", "bead")
    lone = ("a small {noun} of mass {mass}", "a small {noun} ({mass})")
    named = ("a small {noun} {letter} of mass {mass}", "a small {noun} {letter} ({mass})")
    listed = "{letter} ({mass})"

    def suits(self, noun: str, bodies: Mapping[str, Body]) -> bool:
        """Return whether it is light enough for a bead, if it is to be called so."""
        del bodies
        return noun != "bead" or self.mass <= HEAVIEST_BEAD

    @property
    def look(self) -> Small:
        """A filled circle."""
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
    named = ("a small {noun} {letter} of mass {mass}", "a small {noun} {letter} ({mass})")

    @property
    def solid(self) -> Solid:
        """A point."""
        return point()

    @property
    def look(self) -> Small:
        """A filled circle."""
        return Small("ball")

    def reach(self, way: Vector) -> float:
        """Nowhere."""
        del way
        return 0.0
