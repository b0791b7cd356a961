"""Simple machines: inclined planes, fixed or movable, tracks and pulleys."""

from math import cos, radians, sin
from typing import Annotated

from annotated_types import Ge, Gt, Le

from sim2reason.scenes.dsl.body import Axial, BigBox, Body, FixedPlane, MovingSlope, PulleyWheel, body
from sim2reason.scenes.dsl.builder import Frame
from sim2reason.scenes.dsl.measures import (
    LEAST,
    Above,
    Angle,
    Chance,
    Friction,
    Mass,
    Measure,
    MomentOfInertia,
    Range,
    StaticFriction,
)
from sim2reason.scenes.dsl.template import Word
from sim2reason.scenes.dsl.vectors import Vector

Smoothness = Word("friction", {0.0: "smooth"}, "rough")


@body
class Plane(Body):
    """A fixed plane; its coefficient of friction is also that of static friction unless a separate one is given."""

    angle: Angle
    friction: Friction
    static_friction: StaticFriction | None = None

    nouns = ("plane",)
    letters = ""
    lone = ("a fixed {surface} {tilt}", "a {surface}, fixed {tilt}")
    again = ("another fixed {with}", "another fixed {whose}")
    words = {
        "surface": Smoothness,
        "tilt": Word("angle", {0.0: "horizontal plane"}, "plane inclined at {angle} to the horizontal"),
        "with": Word(
            "angle",
            {0.0: "horizontal plane with a {surface} surface"},
            "plane of inclination {angle} with a {surface} surface",
        ),
        "whose": Word(
            "angle",
            {0.0: "horizontal plane whose surface is {surface}"},
            "plane of inclination {angle} whose surface is {surface}",
        ),
        "uphill": Word("angle", {0.0: "to the right along the plane"}, "up the slope"),
        "downhill": Word("angle", {0.0: "to the left along the plane"}, "down the slope"),
        "above": Word("angle", {0.0: "from the right"}, "from above, along the slope"),
        "below": Word("angle", {0.0: "from the left"}, "from below, along the slope"),
        "lower": Word("angle", {0.0: "on the left"}, "lower down"),
        "order": Word("angle", {0.0: "left to right"}, "the lowest to the highest"),
    }

    def directions(self) -> tuple[Vector, Vector]:
        """Return the unit vectors up the slope, which rises to the right, and out of the plane."""
        slope = radians(self.angle)
        return (cos(slope), 0.0, sin(slope)), (-sin(slope), 0.0, cos(slope))

    @property
    def look(self) -> FixedPlane:
        """Return the drawn shape: a hatched line, or a slope."""
        return FixedPlane(self.angle)


@body
class Box(Body):
    """A box with a level top, moving without turning."""

    mass: Mass
    friction: Friction = 0.0
    static_friction: StaticFriction | None = None

    nouns = ("box",)
    letters = "WVUY"
    lone = ("a box of mass {mass} with a {surface} top", "a large box ({mass}) with a {surface} top")
    named = ("box {letter} of mass {mass} with a {surface} top", "box {letter} ({mass}) with a {surface} top")
    words = {"surface": Smoothness}
    symbols = {"mass": "M"}

    @property
    def look(self) -> BigBox:
        """Return the drawn shape: a rectangle below and between the bodies on it."""
        return BigBox()


@body
class Incline(Body):
    """A fixed plane, level or inclined."""

    angle: Annotated[Angle, Range(5.0, 45.0)]

    nouns = ("plane",)
    letters = ""
    lone = ("a fixed {tilt}", "a stationary {tilt}")
    words = {
        **{name: Plane.words[name] for name in ("tilt", "uphill", "downhill", "above", "below")},
        "path": Word("angle", {0.0: "along it in a straight line"}, "straight up or down the slope"),
        "edge": Word("angle", {0.0: "right-hand edge"}, "lower edge"),
    }

    def directions(self) -> tuple[Vector, Vector]:
        """Return the unit vectors up the slope, which rises to the right, and out of the plane."""
        return Plane(angle=self.angle, friction=0.0).directions()

    @property
    def look(self) -> FixedPlane:
        """Return the drawn shape: a hatched line, or a slope."""
        return FixedPlane(self.angle)


TrackSlope = Annotated[
    float, Ge(0), Le(85), Measure("angle", "deg", r"\theta", decimals=0), Range(5.0, 40.0), Chance(0.3)
]


@body
class Track(Body):
    """A straight smooth track that rises to the right, if at all."""

    angle: TrackSlope = 0.0

    nouns = ("track",)
    letters = ""
    lone = ("a straight smooth {lie}", "a straight and smooth {lie}")
    words = {
        "lie": Word("angle", {0.0: "horizontal {noun}"}, "{noun} inclined at {angle} to the horizontal"),
        "order": Word("angle", {0.0: "from left to right"}, "from the lowest to the highest"),
        "ahead": Word("angle", {0.0: "to the right"}, "up the slope"),
        "back": Word("angle", {0.0: "to the left"}, "down the slope"),
        "left": Word("angle", {0.0: "on the left"}, "at the bottom"),
        "right": Word("angle", {0.0: "on the right"}, "at the top"),
    }

    @property
    def look(self) -> FixedPlane:
        """Return the drawn shape: a hatched line, or a slope."""
        return FixedPlane(self.angle)

    @property
    def along(self) -> Vector:
        """Return the unit vector to the right, or up the slope."""
        slope = radians(self.angle)
        return (cos(slope), 0.0, sin(slope))

    def carry(self, frame: Frame, speed: float = 0.0, stated: tuple[str, float] | None = None) -> Frame:
        """Let a body move along the track at an initial speed, m/s; `stated` is the label and value of its position."""
        return frame.slide(self.along, speed, name="right", stated=stated)


@body
class RoughTrack(Track):
    """A straight track that may be rough."""

    friction: Annotated[Friction, Chance(0.2)] = 0.0
    static_friction: StaticFriction | None = None

    lone = ("a straight {surface} {lie}", "a straight and {surface} {lie}")
    words = {**Track.words, "surface": Smoothness}

    def carry(self, frame: Frame, speed: float = 0.0, stated: tuple[str, float] | None = None) -> Frame:
        """Let a body move along the track, with friction if it is rough, with an initial speed, m/s."""
        if self.friction == 0.0:
            return super().carry(frame, speed, stated)
        slope = radians(self.angle)
        normal = (-sin(slope), 0.0, cos(slope))
        return frame.rest(self.along, normal, self.friction, speed, name="right", static=self.static_friction)


WedgeSlope = Annotated[float, Gt(0), Le(85), Measure("angle", "deg", r"\theta", decimals=0), Range(10.0, 70.0)]


@body
class Wedge(Body):
    """A wedge with one face that carries blocks."""

    mass: Mass
    angle: WedgeSlope
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
        """Return the drawn shape: a triangle."""
        return MovingSlope()


@body
class Prism(Body):
    """A wedge with two faces, one rising to the right and one falling to the right."""

    mass: Mass
    left: WedgeSlope
    right: WedgeSlope
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
        """Return the drawn shape: a triangle."""
        return MovingSlope()


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

    @property
    def look(self) -> Axial:
        """Return the outline of a cylinder with a step: two concentric circles, as seen from its end."""
        return Axial(self.outer, step=self.inner)
