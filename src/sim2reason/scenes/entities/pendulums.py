"""Pendulums on strings, rods and arms, and the carriage that may carry them."""

from math import cos, radians, sin
from typing import Annotated, Literal, Self

from annotated_types import Le
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    Base,
    Chance,
    End,
    Entity,
    Frame,
    Mount,
    Range,
    Speed,
    Word,
    X,
    Y,
    Z,
    either,
    entity,
    scale,
)
from sim2reason.scenes.bodies.pendulums import Ball, Cord, LightRod
from sim2reason.scenes.bodies.sliders import Carriage
from sim2reason.scenes.entities.parts.assembly import AT_FIRST, SENT_OFF, TILTED, PendulumDeflection, WeldedArm, swings


@entity
class LightRodPendulum(Entity):
    """The rod turns in a vertical plane, which is that of the picture."""

    bob: Ball
    rod: LightRod
    angle: PendulumDeflection
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
        """Return the time of a few oscillations about a fixed point, s."""
        return swings(self.rod.length, gravity)

    def build(self, room: Frame) -> None:
        """Build the ball on an arm about the hinge; a right-handed rotation about y is clockwise for the reader."""
        length, angle = self.rod.length, radians(self.angle) * (1.0 if self.side == "right" else -1.0)
        place = (length * sin(angle), 0.0, -length * cos(angle))
        room.body("bob", self.bob.mass, center=place).hinge(Y, (self.speed or 0.0) / length)


@entity
class Pendulum(Entity):
    """A bob that hangs from a fixed point and starts somewhere on its circle, at rest or along it."""

    bob: Ball
    hanger: Cord | LightRod
    angle: Annotated[PendulumDeflection, Le(175), Range(5.0, 90.0)]
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
        """Return the time of a few oscillations, s."""
        return swings(self.hanger.length, gravity)

    @property
    def tells_taut(self) -> bool:
        """Return whether the bob hangs on a string, whose sentences describe it as taut."""
        return isinstance(self.hanger, Cord)

    @property
    def slackens(self) -> bool:
        """Return whether a launched bob on a string may leave its circle."""
        return isinstance(self.hanger, Cord) and self.speed is not None

    def build(self, room: Frame) -> None:
        """Build the bob on a hinged rod, or free in the plane and held by a string."""
        length, angle, speed = self.hanger.length, radians(self.angle), self.speed or 0.0
        place = (length * sin(angle), 0.0, -length * cos(angle))
        room.site("point")
        if isinstance(self.hanger, LightRod):
            room.body("hanger").hinge(Y, speed / length).body("bob", self.bob.mass, at=place)
            return
        bob = room.body("bob", self.bob.mass, at=place)
        bob.slide(X, -speed * cos(angle), name="across").slide(Z, -speed * sin(angle), name="rise").site("hook")
        room.string("hanger", room.address("point"), room.address("hook"))


@entity
class RigidPendulum(WeldedArm):
    """Pieces welded to a light arm that hangs from another entity."""

    says = (
        either(
            "{arm} can turn in a vertical plane about a horizontal axle.",
            "about a horizontal axle {arm} swings in a vertical plane.",
            "a horizontal axle carries {arm}, which turns on it in a vertical plane.",
        ),
        *WeldedArm.LINES,
    )
    tip = Mount(sites=("tip",), place="the far end of {arm}", needs="reach")
    axle = Base(held="{arm}", required=True)


@entity
class RotationEntity(WeldedArm):
    """Pieces welded to a light arm that turns about a fixed horizontal axle under gravity."""

    says = (
        either(
            "{arm} can turn without friction in a vertical plane about a fixed horizontal axle.",
            "about a fixed horizontal axle {arm} swings without friction in a vertical plane.",
            "a fixed horizontal axle carries {arm}, which turns on it without friction in a vertical plane.",
        ),
        *WeldedArm.LINES,
    )
    tip = Mount(sites=("tip",), place="the far end of {arm}", needs="reach")


@entity
class SliderMass(Entity):
    """The rail guides the carriage and holds it up and down."""

    carriage: Carriage

    says = (
        either(
            "{carriage} slides freely along a straight horizontal rail.",
            "a straight horizontal rail carries {carriage}, which slides on it without friction.",
            "{carriage} is free to slide along a smooth, straight and horizontal rail.",
        ),
    )
    pivot = Mount(sites=("hub",), place="{carriage}")
    left = End(
        sites=("left_eye",),
        tied="{carriage}",
        leaves="runs along the rail to the left",
        arrives="reaches {carriage} along the rail, from the left",
    )
    right = End(
        sites=("right_eye",),
        tied="{carriage}",
        leaves="runs along the rail to the right",
        arrives="reaches {carriage} along the rail, from the right",
    )

    def build(self, room: Frame) -> None:
        """Build the carriage at the origin."""
        carriage = room.body("carriage", self.carriage.mass).slide(X)
        carriage.site("hub").site("left_eye", faces=scale(-1.0, X)).site("right_eye", faces=X)
