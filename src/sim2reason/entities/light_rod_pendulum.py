"""A ball on a light rod that is hinged to something which may move."""

from math import cos, radians, sin
from typing import Literal

from sim2reason.authoring import Base, Entity, Frame, Speed, Word, Y, either, entity
from sim2reason.bodies.ball import Ball
from sim2reason.bodies.hanger import LightRod
from sim2reason.entities.parts.swings import Deflection, swings


@entity
class LightRodPendulum(Entity):
    """The rod turns in a vertical plane, which is that of the picture."""

    bob: Ball
    rod: LightRod
    angle: Deflection
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
        """Of a few swings about a fixed point, s."""
        return swings(self.rod.length)

    def build(self, room: Frame) -> None:
        """The ball on an arm about the hinge; what turns right-handed about y, away from the reader, goes clockwise."""
        length, angle = self.rod.length, radians(self.angle) * (1.0 if self.side == "right" else -1.0)
        place = (length * sin(angle), 0.0, -length * cos(angle))
        room.body("bob", self.bob.mass, center=place).hinge(Y, (self.speed or 0.0) / length)
