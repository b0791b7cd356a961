"""Tests of wrong answers: most items have one, none is graded as right, and none changes the problem."""

from functools import cache
from math import isfinite

import pytest

from sim2reason.generation.item import Item, grade_answer
from sim2reason.generation.make import make
from sim2reason.generation.request import Request
from sim2reason.questions.difficulty import Difficulty, Need
from sim2reason.questions.simplifications import MISCONCEPTIONS
from sim2reason.rewards import boxed

CASES: tuple[tuple[str, Difficulty], ...] = (
    ("pulley", "easy"),
    ("pulley", "hard"),
    ("hybrid", "medium"),
    ("orbital", "medium"),
    ("chain", "easy"),
)


def request(recipe: str, difficulty: Difficulty, index: int = 0, kind: str = "") -> Request:
    weights = ((kind, 1e6),) if kind else ()
    return Request(recipe=recipe, difficulty=difficulty, mode="numeric", seed=5, index=index, weights=weights)


@cache
def made(recipe: str, difficulty: Difficulty, index: int = 0, kind: str = "") -> Item:
    item = make(request(recipe, difficulty, index, kind)).item
    assert item is not None
    return item


def check(item: Item) -> None:
    """Check that no wrong answer earns a reward, and that each has a reason."""
    for wrong in item.distractors:
        assert isfinite(wrong.value)
        assert wrong.value > 0.0 or item.answer.sign
        assert abs(wrong.value / item.answer.value - 1.0) > 2.0 * item.answer.tolerance
        assert grade_answer(item.answer, boxed(f"{wrong.value:.6g}")).reward == 0.0
        assert wrong.simplification in MISCONCEPTIONS
        assert wrong.reason[0].isupper()
        assert "." not in wrong.reason[:-1], "it names an address, or says two things"


@pytest.mark.parametrize(("recipe", "difficulty"), CASES)
def test_no_wrong_answer_is_paid(recipe: str, difficulty: Difficulty) -> None:
    for index in range(2):
        check(made(recipe, difficulty, index))


def test_nearly_every_item_has_one() -> None:
    items = [made(*case, index) for case in CASES for index in range(2)]
    assert sum(bool(item.distractors) for item in items) >= 0.8 * len(items)  # each misses by more than a tenth


def test_of_a_threshold_a_wrong_answer_is_looked_for_far_from_it() -> None:
    item = made("pulley", "medium", 1, "threshold")
    assert item.kind == "threshold"
    assert item.distractors
    check(item)


@pytest.mark.parametrize(
    ("recipe", "difficulty", "kind", "index", "idle"),
    [
        ("chain", "easy", "state", 0, ()),  # carts on a level track, of whose g the text says nothing
        ("springs", "medium", "equilibrium", 41, ("springs.block.mass",)),  # for which it leaves the start out
    ],
)
def test_only_stated_numbers_are_marked(
    recipe: str, difficulty: str, kind: str, index: int, idle: tuple[str, ...]
) -> None:
    weights, needs = ((kind, 1e6),), tuple(need.label for need in Need)
    asked = Request(recipe, difficulty, "numeric", 771, index, weights=weights, unfiltered=True, needs=needs)
    item = make(asked).item
    assert item is not None
    assert (item.kind, item.idle_numbers) == (kind, idle)
