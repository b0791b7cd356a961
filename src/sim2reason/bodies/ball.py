"""A small ball."""

from typing import Annotated

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import Small
from sim2reason.dsl.measures import Mass, Range


@body
class Ball(Body):
    """A ball so small that its size never matters."""

    mass: Annotated[Mass, Range(0.05, 2.0)]

    nouns = ("ball", "bead")
    lone = ("a small {noun} of mass {mass}", "a small {noun} ({mass})")
    named = ("small {noun} {letter} of mass {mass}", "small {noun} {letter} ({mass})")
    listed = "{letter} ({mass})"

    @property
    def look(self) -> Small:
        """A filled circle."""
        return Small("ball")


@body
class Bead(Ball):
    """A small ball that a ring or a wire leads."""

    nouns = ("bead",)
    alike = "({mass} each)"
