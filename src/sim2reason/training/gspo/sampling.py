"""Dynamic sampling: a step is filled with groups of unequal rewards (DAPO, Yu et al. 2025, arXiv:2503.14476).

A group whose rewards are all equal has no advantage to learn from. It is dropped, and fresh prompts are drawn and
answered, until enough groups are good, the rounds are used up or the stream of prompts ends. All processes enter each
round together with equally many prompts, and come to the same decisions, since each sees all rewards.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from math import ceil, isnan
from typing import Protocol

from sim2reason.training.gspo.batches import Group
from sim2reason.training.gspo.stream import Drawn, Row

__all__ = ["Answered", "Filled", "Place", "Sampler", "balance", "fill", "round_size", "spread"]

EQUAL = 1e-6  # rewards that differ by less are equal: float32 means of equal rewards differ by about 1e-8


@dataclass(frozen=True, slots=True)
class Place:
    """Which of how many processes this is."""

    rank: int = 0
    world: int = 1


@dataclass(frozen=True, slots=True)
class Answered:
    """A round of completions."""

    rewards: Sequence[Sequence[float]]
    """Of each prompt of all processes, in the order of the prompts; NaN where nothing could be scored."""
    cut: Callable[[int], Group]
    """The group of a prompt of this process, by its place among these."""


class Sampler(Protocol):
    """What a trainer can do."""

    def draw(self, count: int) -> Drawn:
        """The next `count` prompts; the same on all processes."""
        ...

    def answer(self, rows: Sequence[Row]) -> Answered:
        """Completions of the prompts of this process, and the rewards of all processes."""
        ...

    def observe(self, row: Row, rewards: Sequence[float]) -> None:
        """Take note of the rewards of a prompt, be its group learned from or not."""
        ...


@dataclass
class Filled:
    """A step's groups, and what it took to find them."""

    owners: list[int] = field(default_factory=list[int])
    """Of each good group of all processes, the process that answered it; in the order of the prompts."""
    own: dict[int, Group] = field(default_factory=dict[int, Group])
    """The good groups that this process answered, by their place among all."""
    sizes: list[int] = field(default_factory=list[int])
    """Of the rounds: prompts answered."""
    good: int = 0
    """Groups of unequal rewards, with those that there was no more room for."""
    read: int = 0
    exhausted: bool = False
    rewards: list[float] = field(default_factory=list[float])
    """Of all completions that could be scored, also of groups left out."""

    @property
    def answered(self) -> int:
        """Prompts, of all rounds."""
        return sum(self.sizes)


def fill(sampler: Sampler, place: Place, wanted: int, rounds: int, first: int = 0) -> Filled:
    """As many good groups as wanted, over all processes, or as many as `rounds` rounds and the stream give.

    The first round answers `first` prompts, at least as many as groups are wanted.

    Good groups beyond those wanted are dropped, the last prompts first, so that which are learned from doesn't depend
    on how long they took. To keep them for the next step would be wrong: they come from the policy before this step's
    updates, and would be learned up to twice as many updates late as other completions, at ratios that are clipped.
    Rounds after the first are therefore no larger than the shares of good groups so far make it likely to need.
    """
    filled = Filled()
    while len(filled.owners) < wanted and len(filled.sizes) < rounds and not filled.exhausted:
        drawn = sampler.draw(round_size(wanted, filled, place.world, first))
        filled.read += drawn.read
        filled.exhausted = drawn.exhausted
        if drawn.rows:
            _add_round(filled, sampler, place, drawn.rows, wanted)
    return filled


def round_size(wanted: int, filled: Filled, world: int, first: int = 0) -> int:
    """How many prompts the next round draws, a multiple of the processes'; after the first at most a whole step's."""
    if not filled.sizes:
        return ceil(max(first, wanted) / world) * world
    missing = wanted - len(filled.owners)
    likely = ceil(missing * filled.answered / filled.good) if filled.good else wanted
    return ceil(min(likely, wanted) / world) * world


def _add_round(filled: Filled, sampler: Sampler, place: Place, rows: list[Row], wanted: int) -> None:
    """Answer prompts, and keep the good groups that there is room for.

    Where a stream ends, some are answered twice so that no process waits for another; only the first time counts.
    """
    each = ceil(len(rows) / place.world)
    even = [rows[number % len(rows)] for number in range(each * place.world)]
    first = place.rank * each
    answered = sampler.answer(even[first : first + each])
    filled.sizes.append(len(rows))
    for number, rewards in enumerate(answered.rewards[: len(rows)]):
        scored = [reward for reward in rewards if not isnan(reward)]
        filled.rewards += scored
        sampler.observe(rows[number], scored)
        if not spread(scored):
            continue
        filled.good += 1
        if len(filled.owners) < wanted:
            if number // each == place.rank:
                filled.own[len(filled.owners)] = answered.cut(number - first)
            filled.owners.append(number // each)


def spread(rewards: Sequence[float]) -> bool:
    """Whether the standard deviation of rewards is more than rounding."""
    return bool(rewards) and max(rewards) - min(rewards) > EQUAL


def balance(owners: Sequence[int], world: int) -> list[int]:
    """Which process learns each group, so that all have equally many, or one more; most stay where they are."""
    shares = [len(owners) // world + (rank < len(owners) % world) for rank in range(world)]
    left, homeless, places = list(shares), list[int](), list(owners)
    for number, owner in enumerate(owners):
        if left[owner]:
            left[owner] -= 1
        else:
            homeless.append(number)
    free = [rank for rank in range(world) for _ in range(left[rank])]
    for number, rank in zip(homeless, free, strict=True):
        places[number] = rank
    return places
