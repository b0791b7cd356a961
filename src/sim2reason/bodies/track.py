"""A straight track, level or inclined."""

from math import cos, radians, sin
from typing import Annotated

from annotated_types import Ge, Le

from sim2reason.bodies.plane import Smoothness
from sim2reason.dsl.body import Body, body
from sim2reason.dsl.builder import Frame
from sim2reason.dsl.looks import FixedPlane
from sim2reason.dsl.measures import Chance, Friction, Measure, Range, StaticFriction
from sim2reason.dsl.template import Word
from sim2reason.dsl.vectors import Vector

Slope = Annotated[float, Ge(0), Le(85), Measure("angle", "deg", r"\theta", decimals=0), Range(5.0, 40.0), Chance(0.3)]


@body
class Track(Body):
    """A straight smooth track that rises to the right, if at all."""

    angle: Slope = 0.0

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
        """A hatched line, or a slope."""
        return FixedPlane(self.angle)

    @property
    def along(self) -> Vector:
        """The unit vector to the right, or up the slope."""
        slope = radians(self.angle)
        return (cos(slope), 0.0, sin(slope))

    def carry(self, frame: Frame, speed: float = 0.0, stated: tuple[str, float] | None = None) -> Frame:
        """Let a body move along the track, m/s, which may be an axis of the text: see `Frame.slide`."""
        return frame.slide(self.along, speed, name="right", stated=stated)


@body
class RoughTrack(Track):
    """A straight track that may be rough."""

    friction: Annotated[Friction, Chance(0.2)] = 0.0
    static_friction: StaticFriction | None = None

    lone = ("a straight {surface} {lie}", "a straight and {surface} {lie}")
    words = {**Track.words, "surface": Smoothness}

    def carry(self, frame: Frame, speed: float = 0.0, stated: tuple[str, float] | None = None) -> Frame:
        """Let a body move along the track, m/s; how it presses on the track matters only if that is rough."""
        if self.friction == 0.0:
            return super().carry(frame, speed, stated)
        slope = radians(self.angle)
        normal = (-sin(slope), 0.0, cos(slope))
        return frame.rest(self.along, normal, self.friction, speed, name="right", static=self.static_friction)
