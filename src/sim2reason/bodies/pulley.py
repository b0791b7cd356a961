"""Pulleys: fixed in the room, or carried by a string."""

from typing import Annotated

from annotated_types import Ge, Le

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import PulleyWheel
from sim2reason.dsl.measures import Measure, Range
from sim2reason.dsl.template import Word

PulleyMass = Annotated[float, Ge(0), Le(1e6), Measure("pulley mass", "kg", "M", sought=0.5), Range(0.1, 2.0)]


class Pulley(Body):
    """What all pulleys share. With mass one is a uniform disc, whose radius does not matter."""

    mass: PulleyMass = 0.0

    letters = "PQRSTUVW"
    words = {
        "light": Word("mass", {0.0: "light "}),
        "disc": Word("mass", {0.0: ""}, " (a uniform disc of mass {mass})"),
    }


@body
class FixedPulley(Pulley):
    """A pulley whose axle is fixed in the room."""

    nouns = ("pulley",)
    lone = ("a {light}fixed pulley{disc}", "a {light}pulley fixed in place{disc}")
    named = ("a {light}fixed pulley {letter}{disc}", "a {light}pulley {letter}{disc} fixed in place")

    @property
    def look(self) -> PulleyWheel:
        """A wheel on a bracket."""
        return PulleyWheel(fixed=True, solid=self.mass > 0.0)


@body
class MovablePulley(Pulley):
    """A pulley that rises and falls with the strings that hold it."""

    nouns = ("pulley",)
    lone = ("a {light}movable pulley{disc}", "a {light}hanging pulley{disc}")
    named = ("a {light}movable pulley {letter}{disc}", "a {light}hanging pulley {letter}{disc}")

    @property
    def look(self) -> PulleyWheel:
        """A wheel."""
        return PulleyWheel(fixed=False, solid=self.mass > 0.0)
