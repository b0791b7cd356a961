"""A ball that is thrown, and bounces on level ground."""

from math import cos, radians, sin, sqrt
from typing import Annotated, Literal, Self, cast

from annotated_types import Ge, Le
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    Chance,
    Entity,
    Frame,
    Measure,
    Range,
    Restitution,
    Speed,
    Usually,
    Word,
    X,
    Z,
    assuming,
    defining_axes,
    either,
    entity,
)
from sim2reason.scenes.bodies.pendulums import Ball

LaunchHeight = Annotated[float, Ge(0), Le(1e6), Measure("height", "m", "h"), Range(1.0, 5.0)]
Elevation = Annotated[float, Ge(0), Le(90), Measure("elevation", "deg", r"\theta", decimals=0), Range(0.0, 90.0)]
STRAIGHT = 90.0  # deg, a vertical launch
FLIGHTS = 2.2  # durations of the first flight in the default duration


@entity
class Projectile(Entity):
    """A ball thrown from a height at an angle; each time it lands it rebounds with a part of its vertical speed."""

    ball: Ball
    height: LaunchHeight
    speed: Annotated[Speed | None, Range(1.0, 10.0), Usually(present=True)] = None
    angle: Annotated[Elevation | None, Usually(present=True)] = None
    side: Annotated[Literal["above", "below"], Chance(0.3)] = "above"
    restitution: Annotated[Restitution | None, Range(0.3, 1.0), Chance(0.6)] = None

    words = {
        "place": Word("height", {0.0: "a point on level ground"}, "a point {height} above level ground"),
        "source": Word("height", {0.0: "from level ground"}, "from a height of {height} above level ground"),
        "sense": Word("side", {"above": "up", "below": "down"}),
        "way": Word(
            "angle",
            {0.0: "horizontally", 90.0: "straight {sense}"},
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
            "{ball} is held at {place}.",
            "at {place} there is {ball}.",
            "{place} is where {ball} is held.",
        ).if_given(
            "speed",
            "at t = 0 {ball} is thrown from {place} at speed {speed} {way}.",
            "{ball} is thrown at t = 0 with a speed of {speed} {way} from {place}.",
            "{source} {ball} is launched at t = 0 at speed {speed} {way}.",
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

    @model_validator(mode="before")
    @classmethod
    def _released(cls, given: object) -> object:
        """Remove a given speed of zero, with its angle and side, so that the ball is released from rest."""
        if not isinstance(given, dict):
            return given
        numbers = cast("dict[str, object]", given)
        still = ("speed", "angle", "side") if numbers.get("speed") == 0 else ()
        return {name: held for name, held in numbers.items() if name not in still}

    @model_validator(mode="after")
    def _thrown(self) -> Self:
        if (self.speed is None) is not (self.angle is None):
            raise ValueError(
                "speed, angle: one is given without the other; give both, or neither for a start from rest"
            )
        if self.side == "below" and self.angle in (None, 0.0):
            raise ValueError("side: a ball released or thrown horizontally is not thrown below the horizontal")
        if self.height == 0.0 and self._rise <= 0.0:
            raise ValueError("height: on the ground it can only be thrown upwards; give a height, or an angle above 0")
        return self

    @property
    def _velocity(self) -> tuple[float, float]:
        """Return the components of the ball's initial velocity: horizontal, and vertical (positive upward), m/s."""
        speed, angle = self.speed or 0.0, radians(self.angle or 0.0)
        ahead = cos(angle) if self.angle != STRAIGHT else 0.0  # which rounding would leave a little of
        return speed * ahead, speed * sin(angle) * (1.0 if self.side == "above" else -1.0)

    @property
    def _rise(self) -> float:
        """Return the vertical component of the ball's initial velocity, positive upward, m/s."""
        return self._velocity[1]

    def horizon(self, gravity: float) -> float | None:
        """Return a little more than twice the duration of the flight to the ground, s; None without gravity."""
        if not gravity:
            return None
        return FLIGHTS * (self._rise + sqrt(self._rise**2 + 2.0 * gravity * self.height)) / gravity

    def build(self, room: Frame) -> None:
        """Build a small body that collides with the ground; without a restitution its motion ends there."""
        ball = room.body("ball", self.ball.mass, at=(0.0, 0.0, self.height))
        ball.slide(X, self._velocity[0], name="x")
        lowest = float("-inf") if self.restitution is not None else -self.height
        ball.slide(Z, self._rise, limits=(lowest, float("inf")), name="y")
        if self.restitution is not None:
            room.bump(room, ball, Z, 0.0, self.restitution)
