"""Tests of the corpus of arithmetic solutions: purity, rate of planted slips, and labels of wrong ones."""

from collections import Counter

import pytest

from sim2reason.errors import TrainingError
from sim2reason.training.corpora import build_corpus
from sim2reason.training.corpora.arithmetic import Arithmetic, Drills

PROBLEMS = {"name": "p", "recipe": "rolling", "difficulty": "easy", "kinds": ["state"], "seed": 11}


def corpus(**settings: object) -> Arithmetic:
    found = build_corpus({"kind": "arithmetic", "problems": PROBLEMS, **settings})
    assert isinstance(found, Arithmetic)
    return found


def test_rows_do_not_hang_on_the_number_of_processes() -> None:
    counts = Counter[str](), Counter[str]()
    one, two = (
        list(corpus(items=2, rows_each=3, slips={"function": 0.5}, workers=n).rows(count))
        for n, count in zip((1, 2), counts, strict=True)
    )
    assert one == two
    assert len(one) == 6
    assert len({row.prompt for row in one}) > 4, "other numbers"


def test_slips_are_known_to_be_wrong() -> None:
    clean = list(corpus(items=2, rows_each=3).rows(Counter()))
    assert all(row.right for row in clean)
    wrong = list(corpus(items=2, rows_each=3, slips={"function": 1.0}).rows(Counter()))
    assert sum(row.right is False for row in wrong) >= 5  # near 45° a sine is a cosine


def test_drills_are_right() -> None:
    rows = list(Drills(items=50, operations=4).rows(Counter()))
    assert len({row.completion for row in rows}) == 50
    for row in rows:
        for operation in row.completion.split("; "):
            left, _, result = operation.partition("=")
            sign = next(each for each in "*/+-" if each in left[1:])
            first, _, second = left.partition(sign)
            a, b = float(first), float(second)
            assert {"*": a * b, "/": a / b, "+": a + b, "-": a - b}[sign] == pytest.approx(float(result), rel=6e-3)


def test_hostile_settings() -> None:
    with pytest.raises(TrainingError, match="no such slip: 'sin'"):
        corpus(slips={"sin": 0.5})
    with pytest.raises(TrainingError, match="slips"):
        corpus(slips={"sign": 1.5})
