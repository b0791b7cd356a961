"""A light arm that carries bodies."""

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import Slender


@body
class Arm(Body):
    """A light straight arm, pivoted about an axle."""

    nouns = ("arm",)
    letters = "LMN"
    lone = ("a light straight {noun}", "a straight light {noun}")
    named = ("a light straight {noun} {letter}", "a straight light {noun} {letter}")

    @property
    def look(self) -> Slender:
        """A bar."""
        return Slender("rod")
