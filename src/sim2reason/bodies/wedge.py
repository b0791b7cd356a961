"""Wedges that slide on the floor: with one sloping face, or with two."""

from typing import Annotated

from annotated_types import Gt, Le

from sim2reason.bodies.plane import Smoothness
from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import MovingSlope
from sim2reason.dsl.measures import Friction, Mass, Measure, Range, StaticFriction

Slope = Annotated[float, Gt(0), Le(85), Measure("angle", "deg", r"\theta", decimals=0), Range(10.0, 70.0)]


@body
class Wedge(Body):
    """A wedge with one face that carries blocks."""

    mass: Mass
    angle: Slope
    friction: Friction = 0.0
    static_friction: StaticFriction | None = None

    nouns = ("wedge",)
    letters = "WVUY"
    lone = (
        "a wedge of mass {mass} with a {surface} face at {angle} to the horizontal",
        "a wedge ({mass}) with a {surface} face at {angle} to the horizontal",
    )
    named = (
        "wedge {letter} of mass {mass} with a {surface} face at {angle} to the horizontal",
        "wedge {letter} ({mass}) with a {surface} face at {angle} to the horizontal",
    )
    words = {"surface": Smoothness}
    symbols = {"mass": "M"}

    @property
    def look(self) -> MovingSlope:
        """A triangle."""
        return MovingSlope()


@body
class Prism(Body):
    """A wedge with two faces, one rising to the right and one falling to the right."""

    mass: Mass
    left: Slope
    right: Slope
    friction: Friction = 0.0
    static_friction: StaticFriction | None = None

    nouns = ("prism",)
    letters = "WVUY"
    lone = (
        "a prism of mass {mass} with {surface} faces rising at {left} on the left and {right} on the right",
        "a prism ({mass}) with {surface} faces at {left} (left) and {right} (right) to the horizontal",
    )
    named = (
        "prism {letter} of mass {mass} with {surface} faces rising at {left} on the left and {right} on the right",
        "prism {letter} ({mass}) with {surface} faces at {left} (left) and {right} (right) to the horizontal",
    )
    words = {"surface": Smoothness}
    symbols = {"mass": "M", "left": r"\alpha", "right": r"\beta"}

    @property
    def look(self) -> MovingSlope:
        """A triangle."""
        return MovingSlope()
