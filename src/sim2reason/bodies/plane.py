"""A plane fixed in the room, level or inclined."""

from math import cos, radians, sin

from sim2reason.dsl.body import Body, body
from sim2reason.dsl.looks import FixedPlane
from sim2reason.dsl.measures import Angle, Friction, StaticFriction
from sim2reason.dsl.template import Word
from sim2reason.dsl.vectors import Vector

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
        """The unit vectors up the slope, which rises to the right, and out of the plane."""
        slope = radians(self.angle)
        return (cos(slope), 0.0, sin(slope)), (-sin(slope), 0.0, cos(slope))

    @property
    def look(self) -> FixedPlane:
        """A hatched line, or a slope."""
        return FixedPlane(self.angle)
