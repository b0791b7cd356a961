"""Small entity that passes the conformance kit, and variants with one fault each."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import count
from typing import Annotated, Any, ClassVar

from annotated_types import Len

from sim2reason.scenes.bodies.blocks import Block
from sim2reason.scenes.dsl.body import Body
from sim2reason.scenes.dsl.builder import Frame
from sim2reason.scenes.dsl.entity import ENTITIES, Entity
from sim2reason.scenes.dsl.fields import Profile, Push, Resistance
from sim2reason.scenes.dsl.measures import Count, Hidden, Length, Mass, Measure, Range
from sim2reason.scenes.dsl.mechanism import X, Y, Z
from sim2reason.scenes.dsl.template import Saying, assuming, either
from sim2reason.scenes.dsl.vectors import Maths, Number, Triple, Vector, scale_triple

Thrust = Annotated[float, Measure("force", "N", "F"), Range(1.0, 9.0)]

PUSHED = either(
    "{block} slides on a smooth level track, pushed along it by a steady {thrust}.",
    "on a smooth level track {block} is pushed along by a steady {thrust}.",
    "a steady {thrust} pushes {block} along a smooth level track.",
)


@contextmanager
def registered(*classes: type[Entity]) -> Iterator[None]:
    """Register entity classes within the context."""
    for cls in classes:
        ENTITIES.add(cls.__name__, cls)
    try:
        yield
    finally:
        for cls in classes:
            del ENTITIES._members[cls.__name__]


def pushed(room: Frame, block: Block, thrust: float, name: str = "block") -> Frame:
    """Build a block on a smooth track along x with a constant force on it."""
    body = room.body(name, block.mass).rest(X, Z)
    body.force("thrust", Push(X, Profile(thrust)))
    return body


class Sled(Entity):
    """An entity without a fault: a block on a smooth track under a constant force."""

    block: Block
    thrust: Thrust

    says: ClassVar[tuple[Saying, ...]] = (PUSHED,)

    def build(self, room: Frame) -> None:
        pushed(room, self.block, self.thrust)


class Brake(Sled):
    """A sled on a rough track, whose text does not state the friction."""

    def build(self, room: Frame) -> None:
        body = room.body("block", self.block.mass).rest(X, Z, friction=0.015, speed=1.0)
        body.force("thrust", Push(X, Profile(self.thrust)))


class Wind(Sled):
    """A sled with a second force that its text does not state."""

    def build(self, room: Frame) -> None:
        pushed(room, self.block, self.thrust).force("wind", Push(X, Profile(0.7)))


class Airy(Sled):
    """A sled with air resistance, whose text states that there is none."""

    says: ClassVar[tuple[Saying, ...]] = (
        PUSHED,
        assuming(
            "air resistance is negligible.", "the resistance of the air is negligible.", "neglect air resistance."
        ),
    )

    def build(self, room: Frame) -> None:
        pushed(room, self.block, self.thrust).force("air", Resistance(linear=0.3))


class Twin(Sled):
    """A sled with the text of `Sled`, but half its force in the opposite direction."""

    def build(self, room: Frame) -> None:
        pushed(room, self.block, -0.5 * self.thrust)


class Lamp(Sled):
    """A sled whose text contains a sentence that has no effect on the motion."""

    glow: Annotated[float, Measure("length", "m", "h"), Range(1.0, 3.0)] | None = None

    says: ClassVar[tuple[Saying, ...]] = (
        PUSHED,
        either("a lamp hangs {glow} above it.", "there is a lamp {glow} above it.", "it has a lamp {glow} above it."),
    )


class Constant(Sled):
    """A sled with a field whose range contains only one number."""

    thrust: Annotated[Thrust, Range(2.0, 2.0)]


class Indices(Sled):
    """A sled with two numbers of one symbol, and a third whose symbol equals an indexed one of these."""

    second: Thrust
    third: Annotated[float, Measure("third", "N", "F_1"), Range(1.0, 9.0)]

    says: ClassVar[tuple[Saying, ...]] = (
        either(
            "{block} slides on a smooth level track, pushed along it by {thrust}, {second} and {third}.",
            "on a smooth level track {block} is pushed along by {thrust}, {second} and {third}.",
            "{thrust}, {second} and {third} push {block} along a smooth level track.",
        ),
    )

    def build(self, room: Frame) -> None:
        pushed(room, self.block, self.thrust + 2.0 * self.second + 3.0 * self.third)


class Curved(Sled):
    """A sled whose force is no simple function of the stated numbers."""

    def build(self, room: Frame) -> None:
        pushed(room, self.block, self.thrust**0.3)


class Offset(Sled):
    """A sled whose answers depend on a field marked `Hidden`."""

    offset: Annotated[Length, Hidden()] = 1.0

    def build(self, room: Frame) -> None:
        pushed(room, self.block, self.thrust * self.offset)


class Thin(Sled):
    """A sled with an impossible inertia tensor: one principal moment exceeds the sum of the two others."""

    def build(self, room: Frame) -> None:
        body = room.body("block", self.block.mass, center=(0.0, 0.0, -1.0), inertia=(0.1, 5.0, 0.1, 0.0, 0.0, 0.0))
        body.hinge(Y)
        body.force("thrust", Push(X, Profile(self.thrust)))


@dataclass(frozen=True, slots=True)
class Lying:
    """A drag law that wrongly declares its force constant."""

    strength: float

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Return a force along x that decreases with the velocity."""
        del place, time, maths
        return scale_triple(self.strength - velocity[0], X)

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Return None."""
        del place, maths
        return None

    @property
    def constant(self) -> bool:
        """Return True, wrongly."""
        return True

    def moved(self, by: Vector) -> "Lying":
        """Return the law unchanged, as it doesn't depend on the position."""
        del by
        return self


class Liar(Sled):
    """A sled under a force law that wrongly declares itself constant."""

    def build(self, room: Frame) -> None:
        room.body("block", self.block.mass).rest(X, Z).force("thrust", Lying(self.thrust))


@dataclass(frozen=True, slots=True)
class Moody:
    """A force law whose value differs at each call."""

    strength: float
    asked: "count[int]" = field(default_factory=count, compare=False)

    def force(self, place: Triple, velocity: Triple, time: Number, maths: Maths) -> Triple:
        """Return a force along x."""
        del place, velocity, time, maths
        return scale_triple(self.strength + 0.1 * next(self.asked), X)

    def potential(self, place: Triple, maths: Maths) -> Number | None:
        """Return None."""
        del place, maths
        return None

    @property
    def constant(self) -> bool:
        """Return True, wrongly."""
        return True

    def moved(self, by: Vector) -> "Moody":
        """Return the law unchanged, as it doesn't depend on the position."""
        del by
        return self


class Mood(Sled):
    """A sled under a force law whose value differs at each call."""

    def build(self, room: Frame) -> None:
        room.body("block", self.block.mass).rest(X, Z).force("thrust", Moody(self.thrust))


class Couple(Entity):
    """An entity that needs two blocks, but accepts one."""

    blocks: Annotated[tuple[Block, ...], Len(1, 3), Count(2, 3)]
    thrust: Thrust

    says: ClassVar[tuple[Saying, ...]] = (
        either(
            "{blocks} {blocks:slides/slide} on a smooth level track, each pushed along it by a steady {thrust}.",
            "on a smooth level track {blocks} {blocks:is/are} each pushed along by a steady {thrust}.",
            "a steady {thrust} pushes each of {blocks} along a smooth level track.",
        ),
    )

    def build(self, room: Frame) -> None:
        for number, block in enumerate(self.blocks):
            pushed(room, block, self.thrust, f"blocks.{number}")
        room.site("middle", at=(self.blocks[1].mass, 0.0, 0.0))


class Sponge(Body):
    """A body that no figure can draw."""

    mass: Mass

    nouns = ("sponge",)
    lone = ("a {noun} of mass {mass}", "a {noun} ({mass})")
    named = ("{noun} {letter} of mass {mass}", "{noun} {letter} ({mass})")


class Bath(Sled):
    """A sled with a body that no figure can draw."""

    block: Sponge  # type: ignore[assignment]  # a body of another class

    def build(self, room: Frame) -> None:
        body = room.body("block", self.block.mass).rest(X, Z)
        body.force("thrust", Push(X, Profile(self.thrust)))


class Terse(Sled):
    """A sled with fewer than three wordings of a sentence."""

    says: ClassVar[tuple[Saying, ...]] = (
        either("on a smooth track {thrust} pushes {block}.", "on a smooth track {block} is pushed by {thrust}."),
    )


class Alias(Sled):
    """A sled whose mechanism names its body differently from its field."""

    def build(self, room: Frame) -> None:
        pushed(room, self.block, self.thrust, name="cart")


class Crash(Sled):
    """A sled whose `build` raises an error."""

    def build(self, room: Frame) -> None:
        numbers: dict[str, Any] = {}
        room.body("block", numbers["mass"])
