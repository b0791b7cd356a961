"""Single particles: a ball that is thrown and bounces, and a charged bead in electric and magnetic fields."""

import math
from collections.abc import Mapping
from math import cos, radians, sin, sqrt
from typing import Annotated, Any, ClassVar, Literal, Self, cast

import numpy as np
from annotated_types import Ge, Le
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    ZERO,
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
    Y,
    Z,
    assuming,
    defining_axes,
    either,
    entity,
)
from sim2reason.scenes.bodies.charges import (
    ChargedBead,
    CircularRegion,
    HalfPlane,
    Launched,
    Rectangle,
    Released,
    Strip,
)
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.dsl.measures import MAX_SPEED
from sim2reason.scenes.dsl.model import replace_validated
from sim2reason.scenes.dsl.units import MINUTE, UnitSystem
from sim2reason.scenes.entities.fields import ElectricField, ForceField, MagneticField, Medium

LaunchHeight = Annotated[float, Ge(0), Le(1e6), Measure("height", "m", "h"), Range(1.0, 5.0)]
Elevation = Annotated[float, Ge(0), Le(90), Measure("elevation", "deg", r"\theta", decimals=0), Range(0.0, 90.0)]
VERTICAL_ANGLE = 90.0  # deg, a vertical launch
HORIZON_FLIGHTS = 2.2  # durations of the first flight in the default duration


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
        return {name: value for name, value in numbers.items() if name not in still}

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
        ahead = cos(angle) if self.angle != VERTICAL_ANGLE else 0.0  # which rounding would leave a little of
        return speed * ahead, speed * sin(angle) * (1.0 if self.side == "above" else -1.0)

    @property
    def _rise(self) -> float:
        """Return the vertical component of the ball's initial velocity, positive upward, m/s."""
        return self._velocity[1]

    def horizon(self, gravity: float) -> float | None:
        """Return a little more than twice the duration of the flight to the ground, s; None without gravity."""
        if not gravity:
            return None
        return HORIZON_FLIGHTS * (self._rise + sqrt(self._rise**2 + 2.0 * gravity * self.height)) / gravity

    def build(self, room: Frame) -> None:
        """Build a small body that collides with the ground; without a restitution its motion ends there."""
        ball = room.body("ball", self.ball.mass, at=(0.0, 0.0, self.height))
        ball.slide(X, self._velocity[0], name="x")
        lowest = float("-inf") if self.restitution is not None else -self.height
        ball.slide(Z, self._rise, limits=(lowest, float("inf")), name="y")
        if self.restitution is not None:
            room.bump(room, ball, Z, 0.0, self.restitution)


HORIZON_ANGLE = 8.0  # rad of the fastest rotation or oscillation in the default duration
DEFAULT_DURATION = 2.0  # s, default duration without a time scale of the fields
PATH_LENGTH_RATIO = 1.5  # assumed length of a path through a region, in straight paths
MAX_AIM_ERROR = 12.0  # degrees, largest error of aim of a drawn bead towards a region


@entity
class EmEntity(Entity):
    """It moves in the x-y plane; electric fields lie in it, magnetic ones are square to it."""

    units: ClassVar[UnitSystem] = MINUTE

    magnetic: Annotated[MagneticField | None, Chance(0.7)] = None
    electric: Annotated[ElectricField | None, Chance(0.7)] = None
    medium: Annotated[Medium | None, Chance(0.2)] = None
    region: Annotated[HalfPlane | Strip | Rectangle | CircularRegion | None, Chance(0.4)] = None
    particle: ChargedBead
    start: Launched | Released

    says = (
        either(
            "outside {region} there is no field.",
            "there is a field only in {region}.",
            "there is no field except inside {region}.",
        ),
        either(
            "at t = 0 {particle} {start}.",
            "at t = 0, {particle} {start}.",
            "at the time t = 0 {particle} {start}.",
        ),
        assuming(
            "there is no gravity.",
            "no gravity acts here.",
            "gravity is absent.",
        ),
    )

    @model_validator(mode="after")
    def _moves(self) -> Self:
        if self.magnetic is None and self.electric is None:
            raise ValueError("magnetic, electric: there is no field; give one")
        if isinstance(self.start, Released):
            if self.electric is None:
                raise ValueError("start: a magnetic field does nothing to a bead at rest; launch it")
            if self.region is not None and min(self.region.shape.margins(ZERO, math)) <= 0.0:
                raise ValueError("start: there is no field where the bead is released; launch it, or move the region")
        return self

    @classmethod
    def fitted(cls, drawn: Mapping[str, Any], rng: np.random.Generator) -> Mapping[str, object]:
        """Return a bead that starts towards the region."""
        start, region = drawn["start"], drawn.get("region")
        if region is None or not isinstance(start, Launched):
            return {}
        x, y = region.middle
        angle = round(math.degrees(math.atan2(y, x)) + rng.uniform(-MAX_AIM_ERROR, MAX_AIM_ERROR)) % 360
        return {"start": replace_validated(start, angle=float(angle))}

    @property
    def fields(self) -> dict[str, ForceField]:
        """Return all fields and media by name."""
        fields_by_name = {"magnetic": self.magnetic, "electric": self.electric, "medium": self.medium}
        return {name: field for name, field in fields_by_name.items() if field is not None}

    @property
    def clocked(self) -> bool:
        """Return True, since the bead starts at t = 0."""
        return True

    def horizon(self, gravity: float) -> float:
        """Return the time of about one turn of the fastest field effect, or to reach and cross the region, s."""
        del gravity
        mass, charge = self.particle.mass, self.particle.signed_charge
        fastest = max(field.rate(charge, mass) for field in self.fields.values())
        enough = HORIZON_ANGLE / fastest if fastest else self._speeding_up
        if self.region is None or not isinstance(self.start, Launched):
            return enough
        speed = self.start.speed
        return math.hypot(*self.region.middle) / speed + min(enough, PATH_LENGTH_RATIO * self.region.width / speed)

    @property
    def _speeding_up(self) -> float:
        """Return the default duration, s, reduced if the bead would become too fast for Newton's laws."""
        pushes = [field.law(self.particle.signed_charge).force(ZERO, ZERO, 0.0, math) for field in self.fields.values()]
        most = sum(math.hypot(*map(float, push)) for push in pushes) / self.particle.mass
        return min(DEFAULT_DURATION, MAX_SPEED / most) if most else DEFAULT_DURATION

    def build(self, room: Frame) -> None:
        """Build the bead with two sliding coordinates in a level plane, and a force for each field."""
        vx, vy = self.start.velocity
        bead = room.body("particle", self.particle.mass).slide(X, vx, name="x", stated=("x", 0.0))
        bead.slide(Y, vy, name="y", stated=("y", 0.0))
        region = self.region.shape if self.region is not None else None
        for name, field in self.fields.items():
            bead.force(name, field.law(self.particle.signed_charge), None if field is self.medium else region)
