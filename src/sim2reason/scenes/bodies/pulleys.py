"""Pulleys."""

from typing import Annotated

from annotated_types import Ge, Le

from sim2reason.scenes.dsl.body import Axial, Body, PulleyWheel, body
from sim2reason.scenes.dsl.measures import LEAST, Above, Measure, MomentOfInertia, Range
from sim2reason.scenes.dsl.template import Word

PulleyMass = Annotated[float, Ge(0), Le(1e6), Measure("pulley mass", "kg", "M", sought=0.5), Range(0.1, 2.0)]


class Pulley(Body):
    """Base class of pulleys; one with mass is a uniform disc, whose radius has no effect."""

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
        """Return the drawn shape: a wheel on a bracket."""
        return PulleyWheel(fixed=True, solid=self.mass > 0.0)


@body
class MovablePulley(Pulley):
    """A pulley that rises and falls with the strings that hold it."""

    nouns = ("pulley",)
    lone = ("a {light}movable pulley{disc}", "a {light}hanging pulley{disc}")
    named = ("a {light}movable pulley {letter}{disc}", "a {light}hanging pulley {letter}{disc}")

    @property
    def look(self) -> PulleyWheel:
        """Return the drawn shape: a wheel."""
        return PulleyWheel(fixed=False, solid=self.mass > 0.0)


Outer = Annotated[
    float, LEAST, Le(1e2), Above("inner"), Measure("outer radius", "m", "R", called="radius"), Range(0.2, 0.5)
]
Inner = Annotated[float, LEAST, Le(1e2), Measure("inner radius", "m", "r", called="radius"), Range(0.05, 0.18)]


@body
class SteppedPulley(Body):
    """A pulley of two radii with a moment of inertia about its axle."""

    outer: Outer
    inner: Inner
    inertia: MomentOfInertia

    letters = "PQRSTUVW"
    nouns = ("stepped pulley",)
    lone = (
        "a {noun} of outer radius {outer}, inner radius {inner} and moment of inertia {inertia} about its axle",
        "a {noun} (outer radius {outer}, inner radius {inner}, moment of inertia {inertia} about its axle)",
    )
    named = (
        "a {noun} {letter} of outer radius {outer}, inner radius {inner} and moment of inertia {inertia} about its axle",
        "a {noun} {letter} (outer radius {outer}, inner radius {inner}, moment of inertia {inertia} about its axle)",
    )

    @property
    def look(self) -> Axial:
        """Return the outline of a cylinder with a step: two concentric circles, as seen from its end."""
        return Axial(self.outer, step=self.inner)
