"""Beads on a level ring, joined by springs that lie along it: a chain that closes on itself."""

from math import cos, pi, sin, sqrt
from typing import Annotated, Literal, Self

from annotated_types import Len
from pydantic import model_validator

from sim2reason.authoring import (
    Chance,
    Count,
    Damping,
    Entity,
    Frame,
    Length,
    Member,
    Part,
    Range,
    Sized,
    Speed,
    Z,
    either,
    entity,
    starting,
)
from sim2reason.bodies.ball import Bead
from sim2reason.bodies.spring import Coil
from sim2reason.dsl.mechanism import Elastic
from sim2reason.entities.parts.springs import AT_FIRST, DASHPOTS, STRAINED, Strained

PERIODS = 1.5  # of the heaviest bead on the softest spring that the motion is followed for
LEAST = 0.1  # of the distance between neighbours at the start: no two beads come nearer
Springs = Annotated[tuple[Coil, ...], Len(2, 6), Count(2, 6), Sized(lambda held: len(held["beads"]))]


class Tap(Part):
    """One of the beads that moves at the start, clockwise or not as seen from above."""

    bead: Annotated[int, Member("beads")]
    toward: Literal["clockwise", "anticlockwise"]
    speed: Annotated[Speed, Range(0.2, 1.5)]


@entity
class SpringMassRing(Entity):
    """Beads and springs in a loop; at the start one spring may be strained and one bead be struck."""

    radius: Annotated[Length, Range(0.4, 1.5)]
    beads: Annotated[tuple[Bead, ...], Len(2, 6), Count(2, 4)]
    springs: Springs
    damping: Annotated[Damping | None, Chance(0.2), Range(0.1, 1.0)] = None
    strain: Annotated[Strained, Chance(0.6)] = Strained()
    tap: Annotated[Tap | None, Chance(0.6)] = None

    words = {"strained": STRAINED}
    says = (
        either(
            "{beads} are threaded on a smooth horizontal ring of radius {radius}, at equal distances and in this order anticlockwise as seen from above.",
            "on a smooth horizontal ring of radius {radius} sit {beads}, at equal distances and in this order anticlockwise as seen from above.",
            "a smooth horizontal ring of radius {radius} carries {beads}, at equal distances and in this order anticlockwise as seen from above.",
        ),
        either(
            "light {springs} lie along the ring, in this order, from {beads.first} on to the next bead and so on until the last one ends at {beads.first} again.",
            "along the ring, from each bead on to the next and from the last one to the first, lie light {springs} in this order, beginning at {beads.first}.",
            "each bead is joined to the next along the ring, and the last one to the first, by light {springs} in this order, beginning at {beads.first}.",
        ),
        DASHPOTS,
        AT_FIRST,
        starting(
            "at t = 0 {tap.bead>beads} is struck and starts off {tap.toward} at speed {tap.speed}, {beads:/the other being/the others being} at rest.",
            "just before t = 0 a blow sends {tap.bead>beads} off {tap.toward} at speed {tap.speed}, while {beads:/the other is/the others are} at rest.",
            "{tap.bead>beads} is set moving {tap.toward} at t = 0 with a speed of {tap.speed}, while {beads:/the other is/all others are} at rest.",
            topic="start",
        ),
    )

    @model_validator(mode="after")
    def _moves(self) -> Self:
        if self.strain.by == 0.0 and self.tap is None:
            raise ValueError("strain, tap: no spring is ever strained; strain one or strike a bead")
        energy = 0.5 * self.springs[self.strain.spring].stiffness * self.strain.by**2
        energy += 0.0 if self.tap is None else 0.5 * self.beads[self.tap.bead].mass * self.tap.speed**2
        shortest = (
            self._arc - self.strain.of(index) - sqrt(2.0 * energy / spring.stiffness)
            for index, spring in enumerate(self.springs)
        )
        if min(shortest) < LEAST * self._arc:
            raise ValueError("radius: beads may meet; take a larger ring, or stiffer springs")
        return self

    def horizon(self, gravity: float) -> float:
        """Some periods of the heaviest bead on the softest spring, s."""
        del gravity
        heaviest, softest = max(bead.mass for bead in self.beads), min(spring.stiffness for spring in self.springs)
        return PERIODS * 2.0 * pi * sqrt(heaviest / softest)

    @property
    def _arc(self) -> float:
        """From a bead to the next at the start, m."""
        return 2.0 * pi * self.radius / len(self.beads)

    def build(self, room: Frame) -> None:
        """Beads that turn about the centre; springs along the arcs, each as long as that but for its strain."""
        frames = list[Frame]()
        for index, bead in enumerate(self.beads):
            turn, struck = 2.0 * pi * index / len(self.beads), self.tap if self.tap and self.tap.bead == index else None
            speed = 0.0 if struck is None else struck.speed if struck.toward == "anticlockwise" else -struck.speed
            place = (self.radius * cos(turn), self.radius * sin(turn), 0.0)
            frames.append(room.body(f"beads.{index}", bead.mass, center=place).hinge(Z, speed / self.radius))
        for index, spring in enumerate(self.springs):
            ends = frames[index], frames[(index + 1) % len(frames)]
            length = self._arc - self.strain.of(index)
            law = Elastic(spring.stiffness, length, self.damping or 0.0)
            room.wind(f"springs.{index}", *ends, self.radius, self._arc, law)
