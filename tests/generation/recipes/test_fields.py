"""Tests that problems of charged beads avoid arbitrary instants and, mostly, arbitrary distances."""

from collections import Counter

import pytest

from sim2reason.generation.make import make
from sim2reason.generation.request import Request
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty

COUNT = 8


@pytest.mark.parametrize("difficulty", DIFFICULTIES)
def test_most_ask_for_turning_points_and_extremes(difficulty: Difficulty) -> None:
    made = [make(Request("electromagnetic", difficulty, "numeric", 4, index)).item for index in range(COUNT)]
    asked = Counter(item.asked.event if item.kind != "state" else "an instant" for item in made if item is not None)
    assert asked.total() == COUNT
    assert not asked["an instant"]
    assert asked["away"] <= 1
    wanted = ("whole motion", "velocity turned", "velocity again", "turning point along the field")
    assert sum(asked[name] for name in wanted) >= COUNT - 2
