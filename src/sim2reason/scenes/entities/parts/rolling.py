"""Parts of rolling entities: friction between body and plane, and the initial motion."""

from math import cos, inf, radians, sin
from typing import Annotated, Literal, Self

from annotated_types import Ge, Le
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    AngularVelocity,
    Friction,
    Measure,
    Part,
    Range,
    Speed,
    StaticFriction,
    Vector,
    Word,
    either,
    placing,
)
from sim2reason.scenes.entities.parts.friction import two_coefficients

Bearing = Annotated[float, Ge(0), Le(180), Measure("bearing", "deg", r"\varphi", decimals=0), Range(0.0, 180.0)]
Spin = Annotated[AngularVelocity, Range(5.0, 40.0)]
Way = Literal["up the slope", "down the slope", "to the right"]


class Grip(Part):
    """Base class of the friction between a body and its plane."""

    @property
    def coefficient(self) -> float:
        """Return the coefficient of kinetic friction; infinite if the body never slips."""
        raise NotImplementedError

    @property
    def static(self) -> float | None:
        """Return the coefficient of static friction; None if it does not differ from that of kinetic friction."""
        return None


class NoSlipping(Grip):
    """It never slips."""

    says = (
        either(
            "it rolls without slipping.",
            "there is no slipping.",
            "it never slips on the plane.",
        ),
    )

    @property
    def coefficient(self) -> float:
        """Return infinity, since the body never slips."""
        return inf


class Rough(Grip):
    """It slips where that takes more friction than there is."""

    friction: Friction
    static_friction: StaticFriction | None = None

    says = (
        either(
            "its coefficient of friction with the plane, static and kinetic, is {friction}.",
            "the coefficient of friction (static and kinetic) between it and the plane is {friction}.",
            "between it and the plane the coefficient of friction, static and kinetic, is {friction}.",
        ).if_given("static_friction", *two_coefficients("between it and the plane")),
    )

    @property
    def coefficient(self) -> float:
        """Return the coefficient of kinetic friction, also of static friction unless `static` is given."""
        return self.friction

    @property
    def static(self) -> float | None:
        """Return the coefficient of static friction; None if it does not differ from that of kinetic friction."""
        return self.static_friction


class Start(Part):
    """Base class of initial motions."""

    way: Way

    @property
    def sign(self) -> float:
        """Return the sign of the motion: 1 up the slope or to the right, else −1."""
        return -1.0 if self.way == "down the slope" else 1.0

    def motion(self, radius: float) -> tuple[float, float]:
        """Return the initial speed up the slope, m/s, and the angular velocity in the sense of rolling, rad/s."""
        raise NotImplementedError


class Rolling(Start):
    """It rolls at once."""

    speed: Speed

    says = (
        either(
            "at t = 0 it is already rolling {way} at speed {speed}.",
            "it is set rolling {way} at t = 0 with a speed of {speed}.",
            "at t = 0 it is rolling {way} with a speed of {speed}.",
        ),
    )

    def motion(self, radius: float) -> tuple[float, float]:
        """Return the initial velocities of rolling, v = Rω."""
        return self.sign * self.speed, self.sign * self.speed / radius


class Sliding(Start):
    """It slides without turning at first."""

    speed: Speed

    says = (
        either(
            "at t = 0 it slides {way} at speed {speed} without turning.",
            "it is set sliding {way} at t = 0 with a speed of {speed}, initially without any rotation.",
            "its velocity at t = 0 is {speed}, directed {way}, and it is not turning then.",
        ),
    )

    def motion(self, radius: float) -> tuple[float, float]:
        """Return the initial velocities of sliding, with zero angular velocity."""
        del radius
        return self.sign * self.speed, 0.0


class Spinning(Start):
    """It spins on the spot at first."""

    spin: Spin

    says = (
        either(
            "at t = 0 it is set down with its centre at rest, spinning at {spin} in the sense in which it would roll {way}.",
            "at t = 0 its centre is at rest, and it spins at {spin} in the sense in which it would roll {way}.",
            "it spins on the spot at t = 0, at {spin} and in the sense of rolling {way}.",
        ),
    )

    def motion(self, radius: float) -> tuple[float, float]:
        """Return the initial velocities of the centre, which is zero, and of the rotation."""
        del radius
        return 0.0, self.sign * self.spin


class Hole(Part):
    """Where the hole of a rolling body is at the start; straight above and below `towards` is left as it is."""

    bearing: Bearing
    towards: Literal["uphill", "downhill", "right"] = "downhill"

    words = {
        "place": Word(
            "bearing",
            {0.0: "the hole is straight above its centre", 180.0: "the hole is straight below its centre"},
            "the line from its centre to the hole makes an angle of {bearing} with the upward vertical, on the {towards} side",
        ),
    }
    says = (placing("initially {place}.", "at the start {place}.", "when the motion begins, {place}."),)

    @model_validator(mode="after")
    def _is_said(self) -> Self:
        if self.bearing in (0.0, 180.0) and self.towards != "downhill":
            raise ValueError("towards: a hole straight above or below is on no side; leave it out")
        return self

    @property
    def way(self) -> Vector:
        """Return the unit vector from the centre to the hole; x points uphill or to the right."""
        side = -1.0 if self.towards == "downhill" else 1.0
        return (side * sin(radians(self.bearing)), 0.0, cos(radians(self.bearing)))

    def fits(self, *, level: bool) -> bool:
        """Return whether the direction of the hole is described as a level or a sloping plane requires."""
        return self.bearing in (0.0, 180.0) or level == (self.towards == "right")
