"""What a pendulum's bob hangs by: a string that can go slack, or a rod that can't."""

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import Slender
from sim2reason.dsl.measures import Length
from sim2reason.dsl.template import Word


class Hanger(Body):
    """Something light of a stated length between a fixed point and a bob."""

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
        """A thin line."""
        return Slender("string")


@body
class LightRod(Hanger):
    """A light rigid rod."""

    nouns = ("rod",)
    words = {"straight": Word("length", {}, "makes")}
    lone = ("a light rigid {noun} of length {length}", "a light, rigid {noun} of length {length}")

    @property
    def look(self) -> Slender:
        """A bar."""
        return Slender("rod")
