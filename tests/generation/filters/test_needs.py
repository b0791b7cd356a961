"""Tests of the mathematics that solutions need, checked before an answer is computed, and in a filter."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from sim2reason.generation.filters import FILTERS
from sim2reason.generation.item_search import sample
from sim2reason.generation.question_search import UNSUITED, QuestionSearch
from sim2reason.questions import MODES
from sim2reason.questions.difficulty import EVERY, Need
from sim2reason.solutions import Solution
from sim2reason.solutions.derivation import shortest_solution

SIMPLE = frozenset(need for need in Need if need <= Need.INVERSE_FUNCTION)


@pytest.fixture(scope="module")
def swing() -> QuestionSearch:
    return QuestionSearch(sample("pendulum", "easy", seed=2), 0, needs=SIMPLE)


def test_a_time_of_a_swing_is_not_asked_for(swing: QuestionSearch) -> None:
    """Most times of a swing take an elliptic integral, so that no filter even sees the question."""
    refused = Counter[str]()
    assert swing.ask(MODES["numeric"], np.random.default_rng(1), refused, "time_to_event") is None
    assert refused == {UNSUITED: 1}
    assert "time_to_event" in swing.beyond


def test_all_that_is_asked_needs_what_it_may(swing: QuestionSearch) -> None:
    """Questions of any kind, numeric or reverse, stay within the allowed needs."""
    for seed in range(6):
        mode = ("numeric", "reverse")[seed % 2]
        found = swing.ask(MODES[mode], np.random.default_rng(seed), Counter())
        if found is not None:
            assert found.shortest.needs in SIMPLE


def test_the_filter_refuses_what_needs_more() -> None:
    """A question drawn without a limit may need a special function."""
    free = QuestionSearch(sample("pendulum", "easy", seed=2), 0, unfiltered=True)
    found = free.ask(MODES["numeric"], np.random.default_rng(1), Counter(), "time_to_event")
    assert found is not None
    needs = FILTERS["needs"]
    assert found.candidate.needs == EVERY
    assert not needs.reason(found.candidate)
    assert list(needs.findings(found.candidate)) == ["special function, by energy and circular motion"]
    assert needs.reason(replace(found.candidate, needs=SIMPLE)).startswith("integration: ")
    assert not needs.reason(replace(found.candidate, needs=frozenset({Need.SPECIAL_FUNCTION})))
    assert needs.reason(replace(found.candidate, needs=frozenset({Need.ROOT, Need.INTEGRATION})))


def test_a_limit_does_not_hide_what_is_within_it(swing: QuestionSearch) -> None:
    """A solution found without a limit, but within it, is also found with it."""
    words, study = swing.words, swing.study
    for seed in range(12):
        question = MODES["numeric"].ask(study, words, "", np.random.default_rng(seed))
        if question is None:
            continue
        free = shortest_solution(question.query, study, words)
        limited = shortest_solution(question.query, study, words, most=Need.INVERSE_FUNCTION)
        if free.answer is not None and free.needs <= Need.INVERSE_FUNCTION:
            assert limited.answer == pytest.approx(free.answer, rel=1e-9)
        else:
            assert limited.answer is None


def test_a_solution_that_can_not_be_shown_is_replaced_before_a_question_is_kept(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Filters see solutions that are not recomputed yet, but that of a kept question is."""
    free = QuestionSearch(sample("pulley", "medium", seed=2), 0, unfiltered=True)
    found = free.ask(MODES["numeric"], np.random.default_rng(1), Counter(), "state")
    assert found is not None
    candidate = replace(found.candidate, prompt="")
    before = candidate.solution
    assert before is not None
    assert candidate.checked is candidate
    monkeypatch.setattr("sim2reason.solutions.derivation.verify_solution", lambda *_: Solution("", reason="not shown"))
    other = candidate.checked
    assert other is not candidate
    assert other.solution is not None
    assert other.solution is not before
    assert other.solution.answer == pytest.approx(before.answer, rel=1e-9)
