"""Tests of how a score is shown."""

import pytest

from sim2reason.grading import Outcome, Score
from sim2reason.grading.score import MAX_SHOWN_LENGTH


@pytest.mark.parametrize(
    ("length", "shown"),
    [
        (MAX_SHOWN_LENGTH - 2, "'" + "x" * (MAX_SHOWN_LENGTH - 2) + "'"),
        (MAX_SHOWN_LENGTH - 1, "'" + "x" * (MAX_SHOWN_LENGTH - 2) + "…"),
        (1000, "'" + "x" * (MAX_SHOWN_LENGTH - 2) + "…"),
    ],
)
def test_a_long_answer_is_cut_to_eighty_characters(length: int, shown: str) -> None:
    assert len(shown) == MAX_SHOWN_LENGTH
    score = Score.of(Outcome.WRONG, "x" * length, "it is not y")
    assert repr(score) == f"<Score 0: wrong, parsed={shown}>"


def test_parts_are_counted() -> None:
    half = Score(0.5, Outcome.WRONG, None, "one part is wrong", (Score.of(Outcome.CORRECT, 1.0, "yes"),) * 2)
    assert repr(half) == "<Score 0.5: wrong, parsed=None, parts=2>"
    assert str(half) == "wrong (reward 0.5): one part is wrong"
