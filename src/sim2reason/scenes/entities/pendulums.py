"""Pendulums on strings, rods and arms, rigid bodies on an axle, and the carriage that may carry them."""

from itertools import combinations
from math import cos, pi, radians, sin, sqrt
from typing import Annotated, ClassVar, Literal, Self

from annotated_types import Ge, Le, Len
from pydantic import field_validator, model_validator

from sim2reason.scenes.authoring import (
    GRAVITY,
    AngularVelocity,
    Base,
    Chance,
    Count,
    End,
    Entity,
    Frame,
    Length,
    Measure,
    Mount,
    Range,
    Speed,
    Word,
    X,
    Y,
    Z,
    either,
    entity,
    lines_of,
    placing,
    scale,
    starting,
)
from sim2reason.scenes.bodies.blocks import Carriage
from sim2reason.scenes.bodies.oscillators import Arm, Ball, Cord, LightRod, UniformRod
from sim2reason.scenes.dsl.solids import Axes, compose_axes
from sim2reason.scenes.dsl.template import Saying
from sim2reason.scenes.entities.pieces import AnyPiece, TiltedPiece, WeldedPiece, overlap

PendulumDeflection = Annotated[
    float, Ge(0), Le(180), Measure("deflection", "deg", r"\theta", decimals=0), Range(10.0, 150.0)
]
TILTED = "an angle of {angle} with the downward vertical"
AT_FIRST = placing("initially {start}.", "at the start {start}.", "to begin with, {start}.")
SENT_OFF = starting(
    "at t = 0 {bob} is set moving {sent} at speed {speed}.",
    "at t = 0 {bob} starts moving {sent} at speed {speed}.",
    "at t = 0 {bob} is launched {sent} with a speed of {speed}.",
    topic="start",
)
PENDULUM_PERIODS = 1.5  # periods of a small oscillation in the default duration


def pendulum_duration(length: float, gravity: float) -> float | None:
    """Return the default duration for a bob that swings at a distance `length`, m, from a fixed point, s.

    None if `gravity`, in m/s², is zero, since nothing swings then.
    """
    return PENDULUM_PERIODS * 2.0 * pi * sqrt(length / gravity) if gravity else None


AssemblyDeflection = Annotated[
    float, Ge(0), Le(175), Measure("deflection", "deg", r"\theta", decimals=0), Range(5.0, 90.0)
]
TurnRate = Annotated[AngularVelocity, Range(0.5, 4.0)]
ASSEMBLY_PERIODS, MAX_DURATION = 1.5, 6.0  # periods of a small oscillation in the default duration, and s


class WeldedArm(Entity):
    """Base class of pieces welded to a light straight arm; `says` of a subclass begins with the support of the arm."""

    arm: Arm = Arm()
    pieces: Annotated[tuple[AnyPiece, ...], Len(1, 4), Count(1, 3)]
    reach: Annotated[Length, Range(0.5, 1.5)] | None = None
    angle: AssemblyDeflection
    rate: TurnRate | None = None

    words: ClassVar[dict[str, Word]] = {
        "start": Word(
            "angle",
            {0.0: "{pieces.first.body} is straight below the axle"},
            "the part of the arm from the axle to {pieces.first.body} points {angle} to the right of the downward vertical",
        ),
        "sent": Word("angle", {0.0: "{pieces.first.body} moving to the right"}, "{pieces.first.body} moving downwards"),
    }
    LINES: ClassVar[tuple[Saying, ...]] = (
        lines_of("pieces"),
        either(
            "{arm} ends {reach} from the axle.",
            "the far end of {arm} is {reach} from the axle.",
            "{arm} reaches to {reach} from the axle.",
        ),
        placing("initially {start}.", "at the start {start}.", "when the motion begins, {start}."),
        starting(
            "at t = 0 {arm} starts turning at {rate}, {sent}.",
            "at t = 0 {arm} turns at {rate}, {sent}.",
            "{arm} is set turning at t = 0 with an angular velocity of {rate}, {sent}.",
            topic="start",
        ),
    )

    @field_validator("pieces")
    @classmethod
    def _sided(cls, pieces: tuple[AnyPiece, ...]) -> tuple[AnyPiece, ...]:
        """Set the words for the side of each piece so that they are unambiguous after the earlier pieces."""
        return tuple(piece.told_after(pieces[:number]) for number, piece in enumerate(pieces))

    @model_validator(mode="after")
    def _swings(self) -> Self:
        if self.angle == 0.0 and self.rate is None:
            raise ValueError("angle, rate: the arm hangs at rest; give it a rate, or an angle that is not zero")
        if self.pieces[0].place < 0.0:
            raise ValueError(
                "pieces.0: it is on the other side of the axle; begin with a piece on the side to which the arm points"
            )
        for (i, one), (j, other) in combinations(enumerate(self.pieces), 2):
            if overlap(one, other):
                raise ValueError(f"pieces.{i} and pieces.{j} overlap; put them farther apart on the arm")
        return self

    def horizon(self, gravity: float) -> float | None:
        """Return 1.5 periods 2π√(I/(m g d)) of a small swing, s; on Earth at most 6 s. None without gravity."""
        if not gravity:
            return None
        inertia = moment = 0.0
        for piece in self.pieces:
            solid, mass = piece.shape.solid.turned(piece.axes).moved(scale(piece.place, X)), piece.shape.mass
            arm = solid.center
            inertia += solid.inertia(mass)[1] + mass * (arm[0] ** 2 + arm[2] ** 2)
            moment += mass * arm[0]
        longest = MAX_DURATION * sqrt(GRAVITY / gravity)
        return min(longest, ASSEMBLY_PERIODS * 2.0 * pi * sqrt(inertia / (gravity * max(abs(moment), 1e-9))))

    def build(self, room: Frame) -> None:
        """Build a massless arm on a hinge, with the pieces welded to it."""
        angle = radians(self.angle)
        along, across = (sin(angle), 0.0, -cos(angle)), (cos(angle), 0.0, sin(angle))
        sense = -1.0 if self.angle == 0.0 else 1.0  # a hinge about y takes what hangs to the left
        arm = room.body("arm").hinge(Y, sense * (self.rate or 0.0))
        turned: Axes = (along, Y, across)
        for number, piece in enumerate(self.pieces):
            axes = compose_axes(piece.axes, turned)
            piece.shape.put(arm, f"pieces.{number}.body", scale(piece.place, along), axes)
        if self.reach is not None:
            arm.site("tip", at=scale(self.reach, along))


def holds_axle(piece: WeldedPiece) -> bool:
    """Return whether a piece extends past the axle, which only a thin rod along the arm may."""
    along_arm = isinstance(piece.shape, UniformRod) and not isinstance(piece, TiltedPiece)
    return not along_arm and piece.span[0] < 0.0 < piece.span[1]


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
        return pendulum_duration(self.rod.length, gravity)

    def build(self, room: Frame) -> None:
        """Build the ball on an arm about the hinge; a right-handed rotation about y is clockwise for the reader."""
        length, angle = self.rod.length, radians(self.angle) * (1.0 if self.side == "right" else -1.0)
        position = (length * sin(angle), 0.0, -length * cos(angle))
        room.body("bob", self.bob.mass, center=position).hinge(Y, (self.speed or 0.0) / length)


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
        return pendulum_duration(self.hanger.length, gravity)

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
        position = (length * sin(angle), 0.0, -length * cos(angle))
        room.site("point")
        if isinstance(self.hanger, LightRod):
            room.body("hanger").hinge(Y, speed / length).body("bob", self.bob.mass, at=position)
            return
        bob = room.body("bob", self.bob.mass, at=position)
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
