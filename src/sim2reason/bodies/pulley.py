"""Pulleys: fixed in the room, or carried by a string."""

from typing import Annotated

from annotated_types import Ge, Le

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.measures import Measure, Range
from sim2reason.dsl.template import Word

PulleyMass = Annotated[float, Ge(0), Le(1e6), Measure("pulley mass", "kg", "M"), Range(0.1, 2.0)]
LIGHT = Word("mass", {0.0: "light "})
DISC = Word("mass", {0.0: ""}, " (a uniform disc of mass {mass})")


@body
class FixedPulley(Body):
    """A pulley whose axle is fixed in the room. With mass it is a uniform disc, whose radius does not matter."""

    mass: PulleyMass = 0.0

    nouns = ("pulley",)
    letters = "PQRSTUVW"
    lone = ("a {light}fixed pulley{disc}", "a {light}pulley fixed in place{disc}")
    named = ("a {light}fixed pulley {letter}{disc}", "a {light}pulley {letter}{disc} fixed in place")
    words = {"light": LIGHT, "disc": DISC}


@body
class MovablePulley(Body):
    """A pulley that rises and falls with the strings that hold it."""

    mass: PulleyMass = 0.0

    nouns = ("pulley",)
    letters = "PQRSTUVW"
    lone = ("a {light}movable pulley{disc}", "a {light}pulley{disc} that is free to rise and fall")
    named = ("a {light}movable pulley {letter}{disc}", "a {light}pulley {letter}{disc} that is free to rise and fall")
    words = {"light": LIGHT, "disc": DISC}
