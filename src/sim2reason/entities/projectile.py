"""A ball that is thrown, and bounces on level ground."""

from math import cos, radians, sin, sqrt
from typing import Annotated, Literal, Self

from annotated_types import Ge, Le
from pydantic import model_validator

from sim2reason.authoring import (
    Chance,
    Entity,
    Frame,
    Height,
    Measure,
    Range,
    Restitution,
    Speed,
    Word,
    X,
    Z,
    assuming,
    defining_axes,
    either,
    entity,
)
from sim2reason.bodies.ball import Ball

Elevation = Annotated[float, Ge(0), Le(90), Measure("elevation", "deg", r"\theta", decimals=0), Range(0.0, 90.0)]
FLIGHTS = 2.2  # times the first flight that the motion is followed for


@entity
class Projectile(Entity):
    """A ball thrown from a height at an angle; each time it lands it rebounds with a part of its vertical speed."""

    ball: Ball
    height: Height
    speed: Annotated[Speed, Range(1.0, 10.0)]
    angle: Elevation
    side: Annotated[Literal["above", "below"], Chance(0.3)] = "above"
    restitution: Annotated[Restitution | None, Range(0.3, 1.0), Chance(0.6)] = None

    words = {
        "way": Word(
            "angle",
            {0.0: "horizontally", 90.0: "straight up"},
            "at an angle of {angle} {side} the horizontal",
        ),
        "bounce": Word(
            "restitution",
            {1.0: "its whole vertical speed", 0.0: "no vertical speed"},
            "{restitution} times its vertical speed",
        ),
    }
    says = (
        either(
            "at t = 0 {ball} is thrown from a point {height} above level ground at speed {speed} {way}.",
            "{ball} is thrown at t = 0 with a speed of {speed} {way} from a point {height} above level ground.",
            "from a height of {height} above level ground {ball} is launched at t = 0 at speed {speed} {way}.",
        ),
        defining_axes(
            "the x axis points forward, the y axis straight up.",
            "let the x axis point forward and the y axis straight up.",
            "take the x axis forward and the y axis straight up.",
        ),
        either(
            "each time it lands, it keeps its horizontal velocity and rebounds with {bounce}.",
            "the ground is smooth, and at each landing {ball} rebounds with {bounce}.",
            "whenever {ball} lands, it rebounds with {bounce}, its horizontal velocity unchanged.",
        ),
        assuming(
            "air resistance is negligible.",
            "the resistance of the air is negligible.",
            "neglect air resistance.",
        ),
    )

    @model_validator(mode="after")
    def _thrown(self) -> Self:
        if self.side == "below" and self.angle in (0.0, 90.0):
            raise ValueError("side: a ball thrown horizontally or straight up is not thrown below the horizontal")
        return self

    @property
    def _rise(self) -> float:
        """The vertical velocity at the start, m/s."""
        return self.speed * sin(radians(self.angle)) * (1.0 if self.side == "above" else -1.0)

    def horizon(self, gravity: float) -> float | None:
        """A little more than two flights from where it is thrown to the ground, s; None if it does not come down."""
        if not gravity:
            return None
        return FLIGHTS * (self._rise + sqrt(self._rise**2 + 2.0 * gravity * self.height)) / gravity

    def build(self, room: Frame) -> None:
        """A small body that meets the ground; without a restitution its flight ends there."""
        ball = room.body("ball", self.ball.mass, at=(0.0, 0.0, self.height))
        ball.slide(X, self.speed * cos(radians(self.angle)), name="x")
        lowest = float("-inf") if self.restitution is not None else -self.height
        ball.slide(Z, self._rise, limits=(lowest, float("inf")), name="y")
        if self.restitution is not None:
            room.bump(room, ball, Z, 0.0, self.restitution)
