"""A fixed plane on which things roll; what they do to it is said of them."""

from typing import Annotated

from sim2reason.bodies.plane import Plane
from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import FixedPlane
from sim2reason.dsl.measures import Angle, Range
from sim2reason.dsl.template import Word
from sim2reason.dsl.vectors import Vector


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
        """The unit vectors up the slope, which rises to the right, and out of the plane."""
        return Plane(angle=self.angle, friction=0.0).directions()

    @property
    def look(self) -> FixedPlane:
        """A hatched line, or a slope."""
        return FixedPlane(self.angle)
