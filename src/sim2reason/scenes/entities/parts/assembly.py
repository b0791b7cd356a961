"""Assemblies of rigid bodies on an axle, and bodies that swing."""

from itertools import combinations
from math import cos, pi, radians, sin, sqrt
from typing import Annotated, ClassVar, Self

from annotated_types import Ge, Le, Len
from pydantic import field_validator, model_validator

from sim2reason.scenes.authoring import (
    GRAVITY,
    AngularVelocity,
    Count,
    Entity,
    Frame,
    Length,
    Measure,
    Range,
    Word,
    X,
    Y,
    either,
    lines_of,
    placing,
    scale,
    starting,
)
from sim2reason.scenes.bodies.pendulums import Arm, UniformRod
from sim2reason.scenes.dsl.solids import Axes, composed
from sim2reason.scenes.dsl.template import Saying
from sim2reason.scenes.entities.parts.pieces import AnyPiece, TiltedPiece, WeldedPiece

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


def swings(length: float, gravity: float) -> float | None:
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
            axes = composed(piece.axes, turned)
            piece.shape.put(arm, f"pieces.{number}.body", scale(piece.place, along), axes)
        if self.reach is not None:
            arm.site("tip", at=scale(self.reach, along))


def holds_axle(piece: WeldedPiece) -> bool:
    """Return whether a piece extends past the axle, which only a thin rod along the arm may."""
    along_arm = isinstance(piece.shape, UniformRod) and not isinstance(piece, TiltedPiece)
    return not along_arm and piece.span[0] < 0.0 < piece.span[1]


def overlap(one: WeldedPiece, other: WeldedPiece) -> bool:
    """Return whether two pieces overlap.

    A thin rod may cross another, or be beside a small body; one along the arm may end in a thick body on its own side
    of the axle. Two small bodies may not have the same position.
    """
    spans = one.span, other.span
    thin, point = list[bool](), list[bool]()
    for piece, (low, high) in zip((one, other), spans, strict=True):
        if isinstance(piece.shape, UniformRod):
            thin.append(low < high)
        else:
            point.append(low == high)
    if len(thin) == 2 or (thin and any(point)):
        return False
    if all(point) and not thin:
        return spans[0] == spans[1]
    if any(thin) and one.place * other.place > 0.0:
        return False
    return spans[0][0] < spans[1][1] and spans[1][0] < spans[0][1]
