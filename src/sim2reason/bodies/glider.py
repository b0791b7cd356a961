"""A small body that moves along a straight track, with its place and velocity at the start."""

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import Small
from sim2reason.dsl.measures import Coordinate, Mass, Velocity
from sim2reason.dsl.template import Word


@body
class Glider(Body):
    """A small body on a straight track; its place and velocity are counted to the right, or up the slope."""

    mass: Mass
    x: Coordinate
    v: Velocity

    nouns = ("block", "cart", "puck")
    words = {"moving": Word("v", {0.0: "at rest"}, "moving with velocity {v}")}
    lone = ("a {noun} of mass {mass}", "a {noun} ({mass})")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")
    listed = "{letter} ({mass})"

    @property
    def look(self) -> Small:
        """A block."""
        return Small("block")


@body
class SlidingBall(Glider):
    """A small ball that slides along a straight smooth track, without turning."""

    nouns = ("ball", "sphere")

    @property
    def look(self) -> Small:
        """A circle as high as a block."""
        return Small("sphere")
