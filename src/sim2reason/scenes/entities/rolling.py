"""Round bodies that roll, and prisms that tumble: friction with the plane, and the initial motion."""

from math import cos, inf, pi, radians, sin
from typing import Annotated, Literal, Self

from annotated_types import Ge, Le
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    ZERO,
    AngularVelocity,
    End,
    Entity,
    Frame,
    Friction,
    Measure,
    Part,
    Range,
    Speed,
    StaticFriction,
    Vector,
    Word,
    Y,
    either,
    entity,
    inner,
    lines_of,
    outer,
    placing,
    scale,
)
from sim2reason.scenes.bodies.blocks import LongPrism
from sim2reason.scenes.bodies.eccentric_bodies import BoredCylinder, SphereWithHole
from sim2reason.scenes.bodies.round_bodies import (
    Disc,
    HollowSphere,
    Hoop,
    Pipe,
    Roller,
    Sphere,
    SphericalShell,
    ThickPipe,
)
from sim2reason.scenes.bodies.simple_machines import Incline
from sim2reason.scenes.dsl.solids import axes_along
from sim2reason.scenes.entities.string_ends import two_coefficients

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


Holed = BoredCylinder | SphereWithHole
Centred = Sphere | HollowSphere | SphericalShell | Roller | Pipe | ThickPipe | Disc | Hoop


@entity
class RollingEntity(Entity):
    """A sphere, cylinder or hoop on a plane: it rolls, or slides till it rolls; a string may draw it by its axle."""

    body: Centred | Holed
    plane: Incline
    hole: Hole | None = None
    grip: NoSlipping | Rough
    start: Rolling | Sliding | Spinning | None = None

    says = (
        either(
            "{body} is placed on {plane} and can roll {plane.path}.",
            "on {plane} there is {body}, free to roll {plane.path}.",
            "{plane} carries {body}, which can roll {plane.path}.",
        ),
        lines_of("hole"),
        lines_of("grip"),
        lines_of("start"),
    )
    axle = End(
        sites=("axle",),
        tied="the axle of {body}",
        leaves="runs {plane.uphill}",
        arrives="reaches the axle of {body} {plane.above}",
    )

    @model_validator(mode="after")
    def _fits(self) -> Self:
        level = self.plane.angle == 0.0
        if (self.hole is not None) != isinstance(self.body, Holed):
            raise ValueError("hole: say where it is at the start if the body has one, and only then")
        if self.hole is not None and not self.hole.fits(level=level):
            raise ValueError("hole.towards: it is right on a level plane, uphill or downhill on a slope")
        if self.start is not None and level != (self.start.way == "to the right"):
            raise ValueError("start.way: it is to the right on a level plane, up or down the slope on another")
        if self.grip.coefficient == inf and isinstance(self.start, Sliding | Spinning):
            raise ValueError("start: what never slips can't slide or spin on the spot; let it roll, or give a friction")
        return self

    def build(self, room: Frame) -> None:
        """Build the body, perhaps unbalanced, with a sliding coordinate along the plane and a hinge about its axis."""
        uphill, normal = self.plane.directions()
        axes = axes_along(Y) if self.hole is None else (outer(Y, self.hole.way), Y, self.hole.way)
        speed, spin = (0.0, 0.0) if self.start is None else self.start.motion(self.body.radius)
        frame = self.body.put(room, "body", ZERO, axes)
        frame.roll(uphill, normal, self.body.radius, self.grip.coefficient, speed, spin, static=self.grip.static)
        frame.site("axle", faces=uphill)


TUMBLES, MAX_DURATION = 5, 2.0  # face changes in the default duration, and s
MIN_SIDES = 5  # least number of sides: with four, a landing leaves a sixteenth of the energy, with three none


@entity
class TumblingPrism(Entity):
    """A prism on one of its faces that tips over an edge; where the next edge lands it stays, and turns on about it."""

    prism: LongPrism
    plane: Incline
    rate: Annotated[AngularVelocity | None, Range(1.0, 5.0)] = None

    says = (
        either(
            "{prism} lies with one face on {plane}, its axis horizontal.",
            "on {plane}, on one face and with its axis horizontal, lies {prism}.",
            "{plane} carries {prism}, which lies on one face, its axis horizontal.",
        ),
        either(
            "its edges never slip on the plane, and an edge that lands on it does not rebound.",
            "no edge slips on the plane, and none rebounds when it lands there.",
            "whenever an edge lands on the plane it neither rebounds nor slips.",
        ),
        either(
            "at t = 0 it begins to tip over its {plane.edge} with an angular velocity of {rate}.",
            "it starts with an angular velocity of {rate} about its {plane.edge}, over which it tips.",
            "a sudden push makes it tip over its {plane.edge}, with an initial angular velocity of {rate}.",
        ),
    )

    @model_validator(mode="after")
    def _tumbles(self) -> Self:
        if self.prism.sides < MIN_SIDES:
            problem = f"a {self.prism.shape} prism does not tumble on: its first landing takes nearly all its energy"
            raise ValueError(f"prism.shape: {problem}; give at least {MIN_SIDES} sides")
        if self.rate is None and self.plane.angle <= 180.0 / self.prism.sides:
            raise ValueError("rate: the prism stays on its face on so gentle a slope; say how fast it tips at first")
        return self

    def horizon(self, gravity: float) -> float:
        """Return the time of five rotations from face to face at the initial angular velocity, s."""
        del gravity
        return min(MAX_DURATION, TUMBLES * 2.0 * pi / self.prism.sides / self.rate) if self.rate else 0.5 * MAX_DURATION

    def build(self, room: Frame) -> None:
        """Build a body free in the plane of the motion, with its edges as feet."""
        uphill, normal = self.plane.directions()
        edges, apothem = self.prism.edges(uphill, normal), self.prism.apothem
        sense = 1.0 if self.plane.angle == 0.0 else -1.0
        rate = sense * (self.rate or 0.0)  # positive if it tips to the right
        edge = scale(1.0 / self.prism.radius, edges[0])
        frame = self.prism.put(room, "prism", scale(apothem, normal), (edge, outer(Y, edge), Y)).slide(
            uphill, rate * apothem
        )
        frame.slide(normal, rate * sense * inner(edges[0], uphill), name="rise").hinge(Y, rate)
        for number, position in enumerate(edges):
            frame.stand(f"edge{number}", position, uphill, normal, on=scale(-apothem, normal))
