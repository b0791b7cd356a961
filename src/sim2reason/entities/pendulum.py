"""A pendulum: a bob on a string or on a light rod, in a vertical plane."""

from math import cos, radians, sin
from typing import Annotated, Self

from annotated_types import Le
from pydantic import model_validator

from sim2reason.authoring import Chance, Entity, Frame, Range, Speed, Word, X, Y, Z, either, entity
from sim2reason.bodies.ball import Ball
from sim2reason.bodies.hanger import Cord, LightRod
from sim2reason.entities.parts.swings import AT_FIRST, SENT_OFF, TILTED, Deflection, swings


@entity
class Pendulum(Entity):
    """A bob that hangs from a fixed point and starts somewhere on its circle, at rest or along it."""

    bob: Ball
    hanger: Cord | LightRod
    angle: Annotated[Deflection, Le(175), Range(5.0, 90.0)]
    speed: Annotated[Speed | None, Chance(0.5)] = None

    words = {
        "start": Word("angle", {0.0: "{bob} hangs straight down"}, "{hanger} {hanger.straight} " + TILTED),
        "sent": Word("angle", {0.0: "horizontally"}, "downwards along its arc"),
    }
    says = (
        either(
            "{bob} hangs from a fixed point by {hanger}.",
            "{hanger} joins {bob} to a fixed point.",
            "from a fixed point {bob} hangs on {hanger}.",
        ),
        AT_FIRST,
        SENT_OFF,
    )

    @model_validator(mode="after")
    def _swings(self) -> Self:
        if self.angle == 0.0 and self.speed is None:
            raise ValueError("angle, speed: the bob hangs at rest; give it a speed, or an angle that is not zero")
        return self

    def horizon(self, gravity: float) -> float | None:
        """Of a few swings, s."""
        return swings(self.hanger.length, gravity)

    @property
    def tells_taut(self) -> bool:
        """It says how the string hangs."""
        return isinstance(self.hanger, Cord)

    @property
    def slackens(self) -> bool:
        """A bob on a string that is launched may leave its circle; from what angle and how fast may be unknown."""
        return isinstance(self.hanger, Cord) and self.speed is not None

    def build(self, room: Frame) -> None:
        """On a rod it turns about the point; on a string it moves in the plane, held by the string alone."""
        length, angle, speed = self.hanger.length, radians(self.angle), self.speed or 0.0
        place = (length * sin(angle), 0.0, -length * cos(angle))
        room.site("point")
        if isinstance(self.hanger, LightRod):
            room.body("hanger").hinge(Y, speed / length).body("bob", self.bob.mass, at=place)
            return
        bob = room.body("bob", self.bob.mass, at=place)
        bob.slide(X, -speed * cos(angle), name="across").slide(Z, -speed * sin(angle), name="rise").site("hook")
        room.string("hanger", room.address("point"), room.address("hook"))
