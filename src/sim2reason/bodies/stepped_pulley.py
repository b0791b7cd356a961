"""A stepped pulley: two drums of different radii on one axle, which turn together."""

from typing import Annotated

from annotated_types import Le

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import Axial
from sim2reason.dsl.measures import LEAST, Above, Measure, MomentOfInertia, Range

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
