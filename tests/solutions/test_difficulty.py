"""Tests of the difficulty of a problem by its solution, and of the documented labels."""

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import pytest

from sim2reason.datasets.items import make_item
from sim2reason.generation.filters import FILTERS
from sim2reason.generation.request import Request
from sim2reason.questions.difficulty import DIFFICULTIES, NEED_DESCRIPTIONS, Need
from sim2reason.solutions import STRATEGIES, Solution, Step
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Root
from sim2reason.solutions.difficulty import (
    LABELS,
    SolutionDifficulty,
    count_coupled_unknowns,
    count_different_laws,
    measure_difficulty,
)
from sim2reason.solutions.solution import Condition, Coordinate, Integration, Phase, Relation

PAGE = Path(__file__).parents[2] / "docs" / "difficulty.md"
F, M, A, B, T, V = (Symbol(name) for name in ("F", "m_A", "a_A", "m_B", "T", "v"))


def law(left: Expression, right: Expression) -> Relation:
    return Relation(left, right, "law")


def step(*relations: Relation, gives: tuple[str, ...] = ()) -> Step:
    return Step(0, "newton", "", relations, gives, ())


GIVEN = step(*(Relation(name, Number(1.0), "given") for name in (F, M, B)))
TOGETHER = step(law(M * A, F - T), law(B * A, T))
SOLVED = step(Relation(A, F / (M + B), "result"), gives=("a_A",))


def solution(*steps: Step, phases: int = 0) -> Solution:
    return Solution("s", steps, goal="a_A", answer=0.5, phases=tuple(Phase("", "") for _ in range(phases)))


def test_unknowns_that_laws_connect_are_found_together() -> None:
    """The acceleration and the tension of two blocks are coupled; a speed defined by one law is not."""
    assert count_coupled_unknowns(solution(GIVEN, TOGETHER, SOLVED)) == 2
    alone = step(law(V, Root(A * F)), gives=("v",))
    assert count_coupled_unknowns(solution(GIVEN, TOGETHER, SOLVED, alone)) == 2
    assert count_coupled_unknowns(solution(GIVEN, SOLVED)) == 1


def test_a_law_that_holds_for_another_body_is_the_same() -> None:
    """Laws that differ in subscripts only count once; another form is another law."""
    found = solution(
        step(law(Symbol("m_A") * Symbol("a_A"), F), law(Symbol("m_B") * Symbol("a_{B,2}"), F), law(T, F * V))
    )
    assert count_different_laws(found) == 2


def test_the_score_adds_up() -> None:
    """The score counts two laws and a second unknown, and two points for each further phase up to the fourth."""
    whole = solution(GIVEN, TOGETHER, SOLVED)
    assert measure_difficulty((whole, 0)) == SolutionDifficulty(laws=2, phases=1, unknowns=2, needs=Need.ARITHMETIC)
    assert measure_difficulty((whole, 0)).score == 3
    assert measure_difficulty((whole, 2)).score == measure_difficulty((solution(*whole.steps, phases=3), 0)).score == 7
    assert measure_difficulty((whole, 9)).score == 9
    rooted = solution(GIVEN, TOGETHER, step(Relation(A, Root(F), "result"), gives=("a_A",)))
    assert measure_difficulty((rooted, 0)).score == 4


def test_parts_are_measured_together() -> None:
    """Laws are counted over all parts; phases, unknowns and needs are the maxima over the parts."""
    whole = solution(GIVEN, TOGETHER, SOLVED)
    later = solution(GIVEN, TOGETHER, step(law(V, Root(A * F)), gives=("v",)))
    both = measure_difficulty((whole, 3), (later, 1))
    assert both == SolutionDifficulty(laws=3, phases=4, unknowns=2, needs=Need.QUADRATIC)
    assert measure_difficulty((later, 1), (whole, 3)) == both


def test_what_only_assumptions_are_verified_by_needs_nothing() -> None:
    checked = step(Relation(V, Root(F), "verified"))
    assert solution(GIVEN, SOLVED, checked).needs == Need.ARITHMETIC
    falling = Coordinate("s", "v", "a", Number(0.0), Number(0.0))
    phase = Integration("t", Number(0.0), (falling,), (), (law(A, F),), Condition(Symbol("t") - T), (("v", "v_1"),))
    integrated = replace(step(), integration=phase)
    assert solution(GIVEN, integrated).needs == Need.INTEGRATION
    assert Solution("", reason="none").needs == Need.INTEGRATION


def test_the_page_has_the_tables_of_the_code() -> None:
    """The documentation page has a row for each label and each need as declared in the code."""
    lines = PAGE.read_text(encoding="utf-8").splitlines()
    labels = [f"| {name} | {band.text} | {band.meaning} |" for name, band in LABELS.items()]
    needs = [f"| {need.label} | {meaning} |" for need, meaning in NEED_DESCRIPTIONS.items()]
    for rows in (labels, needs):
        first = lines.index(rows[0])
        assert lines[first : first + len(rows) + 1] == [*rows, ""]
    assert tuple(LABELS) == DIFFICULTIES
    assert set(NEED_DESCRIPTIONS) == set(Need)


def test_bands_ascend_and_overlap() -> None:
    bands = [LABELS[name] for name in DIFFICULTIES]
    for easier, harder in pairwise(bands):
        assert easier.least < harder.least <= easier.most < harder.most


@pytest.mark.parametrize("recipe", ["pulley", "incline", "projectile"])
def test_an_item_fits_its_label(recipe: str) -> None:
    """The item's own measures agree with those of its solution."""
    for label in DIFFICULTIES:
        item, found = make_item(Request(recipe, label, "numeric", 21, 0))
        assert item.measured is not None
        assert item.measured.score in LABELS[label]
        assert found.measured is not None
        assert item.measured.score == found.measured.score
        assert item.measured.laws == found.measured.laws


def test_a_question_of_another_difficulty_is_refused() -> None:
    """A question is refused only if a label was ordered."""
    _, found = make_item(Request("pulley", "hard", "numeric", 21, 0))
    candidate, difficulty = found.candidate, FILTERS["difficulty"]
    assert candidate.measured is not None
    assert not difficulty.reason(candidate)
    easy = replace(candidate, difficulty="easy")
    hard = candidate.measured.score not in LABELS["easy"]
    assert difficulty.reason(easy).startswith("too hard: ") == hard
    assert not difficulty.reason(replace(easy, labelled=False))


def test_every_strategy_declares_whether_it_integrates() -> None:
    """The declaration shows a problem's needs without a numerical integration."""
    assert [found.name for found in STRATEGIES.values() if found.integrates] == ["integration"]
