"""What a pendulum's bob hangs by: a string that can go slack, or a rod that can't."""

from sim2reason.dsl.body import Body, body
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
    words = {"taut": Word("length", {}, ", taut,")}
    lone = ("a light inextensible {noun} of length {length}", "a light inextensible {noun} {length} long")


@body
class LightRod(Hanger):
    """A light rigid rod."""

    nouns = ("rod",)
    words = {"taut": Word("length", {})}
    lone = ("a light rigid {noun} of length {length}", "a light rigid {noun} {length} long")
