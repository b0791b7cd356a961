"""A ball on a light rod that is hinged to something which may move."""

from math import cos, pi, radians, sin, sqrt
from typing import Annotated, Literal

from annotated_types import Ge, Le

from sim2reason.bodies.ball import Ball
from sim2reason.bodies.hanger import LightRod
from sim2reason.dsl.builder import Frame
from sim2reason.dsl.entity import Entity, entity
from sim2reason.dsl.measures import Measure, Range, Speed
from sim2reason.dsl.mechanism import GRAVITY, Y
from sim2reason.dsl.ports import Base
from sim2reason.dsl.template import Word, either

Tilt = Annotated[float, Ge(0), Le(180), Measure("deflection", "deg", r"\theta", decimals=0), Range(10.0, 150.0)]
PERIODS = 1.5  # of a small swing about a fixed point that the motion is followed for


@entity
class LightRodPendulum(Entity):
    """The rod turns in a vertical plane, which is that of the picture."""

    bob: Ball
    rod: LightRod
    angle: Tilt
    side: Literal["left", "right"] = "right"
    speed: Speed | None = None

    words = {
        "start": Word(
            "angle",
            {0.0: "the rod hangs straight down", 180.0: "the rod stands upright, {bob} at its top"},
            "the rod makes an angle of {angle} with the downward vertical, {bob} being on the {side}",
        ),
        "begin": Word(
            "angle",
            {0.0: "the rod points straight down", 180.0: "the rod points straight up"},
            "the rod points to the {side}, at {angle} to the downward vertical",
        ),
    }
    says = (
        either(
            "{bob} is fixed to one end of {rod}.",
            "at one end of {rod} sits {bob}.",
            "{rod} carries {bob} at one of its ends.",
        ),
        either("at first {start}.", "at the start {begin}.", "to begin with, {start}."),
        either(
            "{bob} is sent off clockwise along its arc at {speed}.",
            "{bob} is given a speed of {speed}, clockwise along its arc.",
            "{bob} is launched clockwise along its arc with a speed of {speed}.",
        ),
    )
    base = Base(held="the other end of {rod}", required=True)

    @property
    def horizon(self) -> float:
        """A period and a half of a small swing about a fixed point on Earth, s."""
        return PERIODS * 2.0 * pi * sqrt(self.rod.length / GRAVITY)

    def build(self, room: Frame) -> None:
        """The ball on an arm about the hinge; what turns right-handed about y, away from the reader, goes clockwise."""
        length, angle = self.rod.length, radians(self.angle) * (1.0 if self.side == "right" else -1.0)
        place = (length * sin(angle), 0.0, -length * cos(angle))
        room.body("bob", self.bob.mass, center=place).hinge(Y, (self.speed or 0.0) / length)
