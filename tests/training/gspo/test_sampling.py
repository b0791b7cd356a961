"""Tests of how a step is filled with groups, without a model."""

from collections.abc import Sequence
from math import nan

import pytest

from sim2reason.training.gspo.sampling import (
    FilledStep,
    ProcessRank,
    RoundRewards,
    balance,
    fill,
    has_spread,
    round_size,
)
from sim2reason.training.gspo.settings import Drawn, Row

GOOD, BAD = [0.0, 1.0], [1.0, 1.0]


class Scripted:
    """Sampler of all processes: prompts are numbers, and those in `good` have unequal rewards."""

    def __init__(self, good: set[int], world: int = 1, length: int = 10**6) -> None:
        self.good, self.world, self.length = good, world, length
        self.next, self.asked = 0, list[int]()
        self.rows: list[Row] = []
        self.observed: list[tuple[str, list[float]]] = []

    def draw(self, count: int) -> Drawn:
        self.asked.append(count)
        found = range(self.next, min(self.next + count, self.length))
        self.next += len(found)
        self.rows = [{"prompt": str(number)} for number in found]
        return Drawn(list(self.rows), len(found), len(found) < count)

    def observe(self, row: Row, rewards: Sequence[float]) -> None:
        self.observed.append((row["prompt"], list(rewards)))

    def answer(self, rows: Sequence[Row]) -> RoundRewards:
        each = len(rows)
        even = [self.rows[place % len(self.rows)] for place in range(each * self.world)]
        rewards = [GOOD if int(row["prompt"]) in self.good else BAD for row in even]
        return RoundRewards(rewards, lambda number: {"prompt": rows[number]["prompt"]})


def filled(sampler: Scripted, wanted: int, rounds: int = 10) -> list[FilledStep]:
    """Return the groups that each process finds, each with its own copy of the stream."""
    found: list[FilledStep] = []
    for rank in range(sampler.world):
        own = Scripted(sampler.good, sampler.world, sampler.length)
        found.append(fill(own, ProcessRank(rank, sampler.world), wanted, rounds))
        sampler.asked = own.asked
    return found


def prompts(found: Sequence[FilledStep]) -> list[int]:
    """Return the prompts of the groups of all processes, in order."""
    together = {number: int(group["prompt"]) for each in found for number, group in each.own.items()}
    assert len(together) == sum(len(each.own) for each in found)
    return [together[number] for number in sorted(together)]


def test_good_groups_fill_a_step_in_one_round() -> None:
    (found,) = filled(Scripted(set(range(99))), 4)
    assert prompts([found]) == [0, 1, 2, 3]
    assert (found.sizes, found.answered, found.good) == ([4], 4, 4)


@pytest.mark.parametrize("world", [1, 2, 4])
def test_the_first_good_prompts_of_the_stream_are_learned_from_whoever_answers_them(world: int) -> None:
    good = {1, 6, 7, 8, 9, 10, 12, 15}
    found = filled(Scripted(good, world), 4)
    assert prompts(found) == sorted(good)[:4]
    assert len({tuple(each.owners) for each in found}) == 1
    assert len({each.good for each in found}) == 1


def test_a_round_is_as_large_as_the_share_of_good_groups_makes_likely() -> None:
    sampler = Scripted({0, 2, 4, *range(9, 99)})
    filled(sampler, 6)
    assert sampler.asked == [6, 6]  # half are good, so six for the three that are missing
    sampler = Scripted({0, 1, 2, 3, 4, 7, 8})
    filled(sampler, 6)
    assert sampler.asked == [6, 2]


@pytest.mark.parametrize(("owners", "good", "sizes", "expected"), [(0, 0, [8], 8), (6, 6, [8], 4), (7, 8, [99], 8)])
def test_a_round_is_never_larger_than_a_step_and_a_multiple_of_the_processes(
    owners: int, good: int, sizes: list[int], expected: int
) -> None:
    assert round_size(8, FilledStep(owners=[0] * owners, good=good, sizes=sizes), 4) == expected


def test_a_larger_first_round_makes_others_rarer() -> None:
    sampler = Scripted({0, 2, 4, 5, 7, 8}, world=2)
    found: list[FilledStep] = []
    for rank in range(2):
        own = Scripted(sampler.good, 2)
        found.append(fill(own, ProcessRank(rank, 2), 4, 10, first=7))
        assert own.asked == [8]
    assert prompts(found) == [0, 2, 4, 5]


def test_rounds_are_used_up() -> None:
    (found,) = filled(Scripted({0, 5}), 4, rounds=3)
    assert prompts([found]) == [0, 5]
    assert len(found.sizes) == 3
    assert not found.exhausted


@pytest.mark.parametrize("world", [1, 2, 4])
def test_a_stream_that_ends_gives_what_it_has_and_each_prompt_once(world: int) -> None:
    found = filled(Scripted(set(range(99)), world, length=5), 8)
    assert prompts(found) == [0, 1, 2, 3, 4]
    assert all(each.exhausted and each.answered == 5 and len(each.rewards) == 10 for each in found)


def test_an_empty_stream_is_not_answered() -> None:
    (found,) = filled(Scripted(set(), length=0), 8)
    assert (found.sizes, found.owners, found.exhausted) == ([], [], True)


def test_equal_rewards_have_no_spread_however_they_round() -> None:
    assert not has_spread([0.7, 0.7000000001, 0.7])
    assert not has_spread([])
    assert has_spread([0.0, 1e-3])


def test_rewards_of_nobody_count_nowhere() -> None:
    class Unscored(Scripted):
        def answer(self, rows: Sequence[Row]) -> RoundRewards:
            return RoundRewards([[nan, nan], [nan, 1.0], [0.0, 1.0]], super().answer(rows).cut)

    sampler = Unscored(set())
    found = fill(sampler, ProcessRank(), 3, rounds=1)
    assert sampler.observed == [("0", []), ("1", [1.0]), ("2", [0.0, 1.0])]
    assert found.owners == [0]
    assert found.rewards == [1.0, 0.0, 1.0]


@pytest.mark.parametrize(
    ("owners", "world", "expected"),
    [
        ([0, 0, 1, 1], 2, [0, 0, 1, 1]),
        ([0, 0, 0, 1], 2, [0, 0, 1, 1]),
        ([1, 1, 1, 1], 2, [1, 1, 0, 0]),
        ([0, 0, 0], 2, [0, 0, 1]),
        ([], 2, []),
    ],
)
def test_all_processes_learn_from_as_many_groups(owners: list[int], world: int, expected: list[int]) -> None:
    assert balance(owners, world) == expected
