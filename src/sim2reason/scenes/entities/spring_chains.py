"""Carts and beads with springs between them, and the initial extension of springs."""

from collections.abc import Mapping
from math import cos, pi, sin, sqrt
from typing import Annotated, Any, Literal, Self

import numpy as np
from annotated_types import Len
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    GRAVITY,
    Chance,
    Count,
    Damping,
    Entity,
    Frame,
    FreeLength,
    Length,
    Member,
    Part,
    Range,
    Sized,
    Speed,
    Strain,
    Word,
    Z,
    either,
    entity,
    placing,
    scale,
    starting,
)
from sim2reason.scenes.bodies.blocks import Cart
from sim2reason.scenes.bodies.oscillators import Bead, Coil, Spring
from sim2reason.scenes.bodies.simple_machines import RoughTrack
from sim2reason.scenes.dsl.mechanism import Elastic
from sim2reason.scenes.dsl.model import replace_validated, round_as_stated
from sim2reason.scenes.entities.string_ends import two_coefficients

START_LENGTH_RATIO = Range(0.85, 1.15)  # initial length of a drawn spring, in natural lengths
FIRM = Range(6.0, 15.0)  # stiffness times length, in weights of the block
MIN_NATURAL_LENGTH = 0.3  # m, natural length
StartLength = Annotated[Length, Range(0.2, 1.0)]
START_LENGTH_SENTENCE = placing(
    "initially {spring} has a length of {start}.",
    "the length of {spring} at the start is {start}.",
    "the initial length of {spring} is {start}.",
)


def fitted_spring(drawn: Mapping[str, Any], rng: np.random.Generator) -> dict[str, object]:
    """Return a `spring` that the weight of the drawn `block` changes little, and a `start` near its natural length."""
    spring, weight = drawn["spring"], GRAVITY * drawn["block"].mass
    length = max(spring.length, MIN_NATURAL_LENGTH)
    stiffness = max(spring.stiffness, rng.uniform(FIRM.low, FIRM.high) * weight / length)
    firm = replace_validated(spring, stiffness=round_as_stated(Spring, "stiffness", stiffness), length=length)
    return {
        "spring": firm,
        "start": round_as_stated(
            Spring, "length", rng.uniform(START_LENGTH_RATIO.low, START_LENGTH_RATIO.high) * length
        ),
    }


class Strained(Part):
    """One of the springs that is stretched or compressed at the start; by 0 if none is."""

    spring: Annotated[int, Member("springs"), Chance(1.0)] = 0
    way: Annotated[Literal["stretched", "compressed"], Chance(1.0)] = "stretched"
    by: Annotated[Strain, Chance(1.0)] = 0.0

    @model_validator(mode="after")
    def _nothing_for_nothing(self) -> Self:
        if self.by == 0.0 and (self.spring, self.way) != (0, "stretched"):
            raise ValueError("by: a spring strained by 0 is relaxed, as are all; leave spring and way out")
        return self

    def of(self, spring: int) -> float:
        """Return the initial extension of a spring given by its index, m."""
        signed = self.by if self.way == "stretched" else -self.by
        return signed if spring == self.spring else 0.0


class Blow(Part):
    """One of the carts that moves at the start."""

    cart: Annotated[int, Member("carts")]
    toward: Literal["right", "left"]
    speed: Annotated[Speed, Range(0.3, 2.0)]

    def velocity(self, cart: int) -> float:
        """Return the initial velocity of a cart given by its index, to the right, m/s."""
        signed = self.speed if self.toward == "right" else -self.speed
        return signed if cart == self.cart else 0.0


DASHPOTS = either(
    "{springs:the spring/each spring} has a light dashpot of damping constant {damping} beside it.",
    "beside {springs:the spring/each spring} acts a light dashpot, whose damping constant is {damping}.",
    "a light dashpot with a damping constant of {damping} acts in parallel with {springs:the spring/each spring}.",
)
"""The sentence of an entity with `springs` that all have the same `damping`."""

STRAINED = Word(
    "strain.by",
    {0.0: "{springs:the spring is/all springs are} relaxed"},
    "{strain.spring>springs} is {strain.way} by {strain.by}{springs:/ and the other spring is relaxed/ and the other springs are relaxed}",
)
"""The word *strained*, by which `STRAIN_SENTENCE` states the spring with a `strain`."""

STRAIN_SENTENCE = placing("initially {strained}.", "at the start {strained}.", "at first {strained}.")


WALLS = {"free": 0, "left": 1, "right": 1, "both": 2}
HORIZON_PERIODS = 1.5  # periods of the heaviest cart on the softest spring in the default duration
ChainSprings = Annotated[
    tuple[Coil, ...], Len(1, 7), Count(1, 7), Sized(lambda held: len(held["carts"]) - 1 + WALLS[held["ends"]])
]


@entity
class SpringMassChain(Entity):
    """Carts and springs in series; at the start one spring may be strained and one cart be struck."""

    track: RoughTrack
    carts: Annotated[tuple[Cart, ...], Len(1, 6), Count(1, 4)]
    ends: Annotated[Literal["free", "left", "right", "both"], Chance(1.0)] = "free"
    springs: ChainSprings
    damping: Annotated[Damping | None, Chance(0.2)] = None
    strain: Annotated[Strained, Chance(0.6)] = Strained()
    blow: Annotated[Blow | None, Chance(0.6)] = None
    spacing: FreeLength = 3.0

    words = {
        "where": Word(
            "ends",
            {
                "free": "from {carts:/{carts.first} to {carts.last}/each of the {carts:s} to the next}",
                "left": "from a fixed wall {track.left} to {carts.first}{carts:/ and from {carts.first} to {carts.last}/ and from each of the {carts:s} to the next}",
                "right": "from {carts:/{carts.first} to {carts.last} and from /each of the {carts:s} to the next and from }{carts.last} to a fixed wall {track.right}",
                "both": "from a fixed wall {track.left} to {carts.first}{carts:/, from {carts.first} to {carts.last}/, from each of the {carts:s} to the next} and from {carts.last} to a fixed wall {track.right}",
            },
        ),
        "strained": STRAINED,
        "toward": Word("blow.toward", {"right": "{track.ahead}", "left": "{track.back}"}),
    }
    says = (
        either(
            "{carts} {carts:stands/stand in a row, {track.order},} on {track}.",
            "on {track} {carts:stands/stand, in this order {track.order},} {carts}.",
            "{track} carries {carts}{carts:/, in this order {track.order}}.",
        ),
        either(
            "the coefficient of friction (static and kinetic) on this track is {track.friction}.",
            "static and kinetic friction on the track have the same coefficient, {track.friction}.",
            "the coefficients of static and of kinetic friction on the track are both {track.friction}.",
        ).if_given("track.static_friction", *two_coefficients("on the track", "track")),
        either(
            "{springs:/light }{springs} {springs:runs/run, in this order,} {where}.",
            "{where} {springs:runs/run, in this order,} {springs:/light }{springs}.",
            "{where} there {springs:is/are, in this order,} {springs:/light }{springs}.",
        ),
        DASHPOTS,
        STRAIN_SENTENCE,
        starting(
            "at t = 0 {blow.cart>carts} is struck and starts off {toward} at speed {blow.speed}{carts:/, the other being at rest/, the others being at rest}.",
            "just before t = 0 a blow sends {blow.cart>carts} off {toward} at speed {blow.speed}{carts:/, while the other is at rest/, while the others are at rest}.",
            "{blow.cart>carts} is set moving {toward} at t = 0 with a speed of {blow.speed}{carts:/, while the other is at rest/, while all others are at rest}.",
            topic="start",
        ),
    )

    @model_validator(mode="after")
    def _moves(self) -> Self:
        if self.strain.by == 0.0 and self.blow is None and (self.track.angle == 0.0 or self.ends == "free"):
            raise ValueError("strain, blow: no spring is ever strained; strain one or strike a cart")
        return self

    def horizon(self, gravity: float) -> float:
        """Return some periods of the heaviest cart on the softest spring, s."""
        del gravity
        heaviest, softest = max(cart.mass for cart in self.carts), min(spring.stiffness for spring in self.springs)
        return HORIZON_PERIODS * 2.0 * pi * sqrt(heaviest / softest)

    def build(self, room: Frame) -> None:
        """Build carts at equal distances, with springs of that length except for their initial strain."""
        along, stops = self.track.along, list[str]()
        if self.ends in ("left", "both"):
            stops.append(room.site("left", at=scale(-self.spacing, along)).address("left"))
        for index, cart in enumerate(self.carts):
            speed = 0.0 if self.blow is None else self.blow.velocity(index)
            frame = room.body(f"carts.{index}", cart.mass, at=scale(index * self.spacing, along))
            self.track.carry(frame, speed).site(f"hook{index}")
            stops.append(room.address(f"hook{index}"))
        if self.ends in ("right", "both"):
            stops.append(room.site("right", at=scale(len(self.carts) * self.spacing, along)).address("right"))
        for index, spring in enumerate(self.springs):
            length, damping = self.spacing - self.strain.of(index), self.damping or 0.0
            joined = stops[index : index + 2]
            room.spring(f"springs.{index}", *joined, stiffness=spring.stiffness, length=length, damping=damping)


MIN_DISTANCE_RATIO = 0.1  # fraction of the initial distance between neighbours: smallest distance of two beads
RingSprings = Annotated[tuple[Coil, ...], Len(2, 6), Count(2, 6), Sized(lambda held: len(held["beads"]))]


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
    springs: RingSprings
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
        STRAIN_SENTENCE,
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
        if min(shortest) < MIN_DISTANCE_RATIO * self._arc:
            raise ValueError("radius: beads may meet; take a larger ring, or stiffer springs")
        return self

    def horizon(self, gravity: float) -> float:
        """Return some periods of the heaviest bead on the softest spring, s."""
        del gravity
        heaviest, softest = max(bead.mass for bead in self.beads), min(spring.stiffness for spring in self.springs)
        return HORIZON_PERIODS * 2.0 * pi * sqrt(heaviest / softest)

    @property
    def _arc(self) -> float:
        """Return the initial arc between neighbouring beads, m."""
        return 2.0 * pi * self.radius / len(self.beads)

    def build(self, room: Frame) -> None:
        """Build beads that rotate about the centre, with springs of the arc length except for their initial strain."""
        frames = list[Frame]()
        for index, bead in enumerate(self.beads):
            turn, struck = 2.0 * pi * index / len(self.beads), self.tap if self.tap and self.tap.bead == index else None
            speed = 0.0 if struck is None else struck.speed if struck.toward == "anticlockwise" else -struck.speed
            position = (self.radius * cos(turn), self.radius * sin(turn), 0.0)
            frames.append(room.body(f"beads.{index}", bead.mass, center=position).hinge(Z, speed / self.radius))
        for index, spring in enumerate(self.springs):
            ends = frames[index], frames[(index + 1) % len(frames)]
            length = self._arc - self.strain.of(index)
            law = Elastic(spring.stiffness, length, self.damping or 0.0)
            room.wind(f"springs.{index}", *ends, self.radius, self._arc, law)
