"""What entities with springs share: how a spring is strained at the start, how a body is struck, and dashpots."""

from typing import Annotated, Literal, Self

from pydantic import model_validator

from sim2reason.scenes.authoring import Chance, Member, Part, Range, Speed, Strain, Word, either, placing


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
        """By how much a spring, given by its index, is longer than it would be by itself, m."""
        signed = self.by if self.way == "stretched" else -self.by
        return signed if spring == self.spring else 0.0


class Blow(Part):
    """One of the carts that moves at the start."""

    cart: Annotated[int, Member("carts")]
    toward: Literal["right", "left"]
    speed: Annotated[Speed, Range(0.3, 2.0)]

    def velocity(self, cart: int) -> float:
        """Of a cart, given by its index, to the right, m/s."""
        signed = self.speed if self.toward == "right" else -self.speed
        return signed if cart == self.cart else 0.0


DASHPOTS = either(
    "{springs:the spring/each spring} has a light dashpot of damping constant {damping} beside it.",
    "beside {springs:the spring/each spring} acts a light dashpot, whose damping constant is {damping}.",
    "a light dashpot with a damping constant of {damping} acts in parallel with {springs:the spring/each spring}.",
)
"""The line of an entity with `springs` that all have the same `damping`."""

STRAINED = Word(
    "strain.by",
    {0.0: "{springs:the spring is/all springs are} relaxed"},
    "{strain.spring>springs} is {strain.way} by {strain.by}{springs:/ and the other spring is relaxed/ and the other springs are relaxed}",
)
"""How an entity with `springs` tells which of them has a `strain`: its word *strained*, which `AT_FIRST` uses."""

AT_FIRST = placing("initially {strained}.", "at the start {strained}.", "at first {strained}.")
