"""A ball on a light rod that is hinged to something which may move."""

from math import cos, radians, sin
from typing import Literal

from sim2reason.authoring import Base, Entity, Frame, Speed, Word, Y, either, entity
from sim2reason.bodies.ball import Ball
from sim2reason.bodies.hanger import LightRod
from sim2reason.entities.parts.swings import AT_FIRST, SENT_OFF, TILTED, Deflection, swings


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
            f"the rod makes {TILTED}, {{bob}} being on the {{side}}",
        ),
        "sent": Word("angle", {}, "clockwise along its arc"),
    }
    says = (
        either(
            "{bob} is fixed to one end of {rod}, which can turn about its other end.",
            "{bob} sits at one end of {rod}, which is free to turn about its other end.",
            "{rod} carries {bob} at one of its ends and can turn about the other.",
        ),
        AT_FIRST,
        SENT_OFF,
    )
    base = Base(held="the other end of {rod}", required=True)

    def horizon(self, gravity: float) -> float | None:
        """Of a few swings about a fixed point, s."""
        return swings(self.rod.length, gravity)

    def build(self, room: Frame) -> None:
        """The ball on an arm about the hinge; what turns right-handed about y, away from the reader, goes clockwise."""
        length, angle = self.rod.length, radians(self.angle) * (1.0 if self.side == "right" else -1.0)
        place = (length * sin(angle), 0.0, -length * cos(angle))
        room.body("bob", self.bob.mass, center=place).hinge(Y, (self.speed or 0.0) / length)
