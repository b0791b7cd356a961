"""Springs of entities and their initial extension."""

from collections.abc import Mapping
from typing import Annotated, Any, Literal, Self

import numpy as np
from pydantic import model_validator

from sim2reason.scenes.authoring import (
    GRAVITY,
    Chance,
    Length,
    Member,
    Part,
    Range,
    Speed,
    Strain,
    Word,
    either,
    placing,
)
from sim2reason.scenes.bodies.spring import Spring
from sim2reason.scenes.dsl.model import replace_validated, round_as_stated

LONG = Range(0.85, 1.15)  # initial length of a drawn spring, in natural lengths
FIRM = Range(6.0, 15.0)  # stiffness times length, in weights of the block
SHORTEST = 0.3  # m, natural length
StartLength = Annotated[Length, Range(0.2, 1.0)]
START_LENGTH_SENTENCE = placing(
    "initially {spring} has a length of {start}.",
    "the length of {spring} at the start is {start}.",
    "the initial length of {spring} is {start}.",
)


def fitted_spring(drawn: Mapping[str, Any], rng: np.random.Generator) -> dict[str, object]:
    """Return a `spring` that the weight of the drawn `block` changes little, and a `start` near its natural length."""
    spring, weight = drawn["spring"], GRAVITY * drawn["block"].mass
    length = max(spring.length, SHORTEST)
    stiffness = max(spring.stiffness, rng.uniform(FIRM.low, FIRM.high) * weight / length)
    firm = replace_validated(spring, stiffness=round_as_stated(Spring, "stiffness", stiffness), length=length)
    return {"spring": firm, "start": round_as_stated(Spring, "length", rng.uniform(LONG.low, LONG.high) * length)}


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
