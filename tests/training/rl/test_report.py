"""Tests of the best constant answer against trying every candidate."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from pydantic import JsonValue

from sim2reason.evaluation.benchmarks import BenchmarkItem
from sim2reason.evaluation.benchmarks.scoring import SCORINGS, Award
from sim2reason.training.rl.report import MAX_CANDIDATES, TOLERANCE_FRACTION, best_constant

ANSWERS = st.lists(st.tuples(st.integers(1, 400), st.sampled_from([0.01, 0.05])), min_size=1, max_size=30)


def item(number: int, value: float, tolerance: float) -> BenchmarkItem:
    answer = {"value": value, "unit": "m", "tolerance": tolerance}
    return BenchmarkItem(id=f"n{number}", prompt="How far?", reference={"answer": answer}, scoring="sim2reason")


def every_one(items: list[BenchmarkItem]) -> int:
    """Return the greatest score of any answer and of both ends of its tolerance."""
    numbers = list[float]()
    for each in items:
        answer = each.reference["answer"]
        assert isinstance(answer, dict)
        value, tolerance = answer["value"], answer["tolerance"]
        assert isinstance(value, float)
        assert isinstance(tolerance, float)
        numbers += [value, (1 - TOLERANCE_FRACTION * tolerance) * value, (1 + TOLERANCE_FRACTION * tolerance) * value]
    said = [f"\\boxed{{{number:.6g}}}" for number in numbers]
    award = SCORINGS["sim2reason"].award
    return max(sum(award(text, each.reference).points == 1.0 for each in items) for text in said)


@given(ANSWERS, st.booleans())
def test_it_is_found_among_all_answers_and_their_ends(answers: list[tuple[int, float]], negative: bool) -> None:
    sign = -1.0 if negative else 1.0
    items = [item(n, sign * value / 10, tolerance) for n, (value, tolerance) in enumerate(answers)]
    assert best_constant(items).value == pytest.approx(every_one(items) / len(items))


def test_no_constant_suits_formulas_and_texts() -> None:
    formula = {"latex": "x", "variables": {}}
    asked = [
        BenchmarkItem(id="a", prompt="What?", reference={"answer": answer}, scoring="exact")
        for answer in ("three", {"value": 2.0, "unit": "m", "tolerance": 0.05, "formula": formula})
    ]
    assert best_constant(asked).value == 0.0


def test_of_many_answers_few_are_scored(monkeypatch: pytest.MonkeyPatch) -> None:
    """A thousand answers give three thousand candidates."""
    rule, scored = SCORINGS["sim2reason"], set[str]()
    award = rule.award

    def counted(response: str, reference: dict[str, JsonValue]) -> Award:
        scored.add(response)
        return award(response, reference)

    monkeypatch.setattr(rule, "award", counted)
    values = np.random.default_rng(0).lognormal(size=1000)
    assert 0.0 < best_constant([item(n, float(value), 0.05) for n, value in enumerate(values)]).value < 0.2
    assert 0 < len(scored) <= MAX_CANDIDATES
