"""Tests of counterexamples: numbers that meet all conditions, but give a formula no value or a negative size."""

from dataclasses import replace

import pytest

from plain_scenes import ramp
from sim2reason.generation.modes.corners import CLOSEST, MAX_SIMULATIONS, SCATTERED, counterexample
from sim2reason.generation.modes.problem_formula import ProblemSymbol, Variation
from sim2reason.generation.modes.variations import Variations
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import Query
from sim2reason.questions.moments.distances import Moved
from sim2reason.questions.regimes.directions import MovesOneWay
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Root

WIDTH = 1.1
LEFT = Number(3.0) - Symbol("m")  # negative for masses of more than 3 kg


@pytest.fixture(scope="module")
def varied() -> Variations:
    """Return variations of the time in which a block of 2 kg goes 0.5 m down a slope."""
    symbols = [ProblemSymbol("m", "kg", 2.0, "ramp.blocks.0.mass"), ProblemSymbol("d", "m", 0.5)]
    study = QuestionSearch(ramp(), 0).study
    return Variations(study, Query("time_to_event", None, Moved("ramp.blocks.0", 0.5)), symbols)


def is_light(other: Variation) -> bool:
    """Return whether a block has less than 4 kg, as an example of a stated condition."""
    return other.values["m"] < 4.0


def test_a_size_is_negative_though_what_is_told_holds(varied: Variations) -> None:
    found = counterexample(varied, LEFT, is_light, WIDTH, signed=False)
    assert found is not None
    assert 3.0 < found.values["m"] < 4.0


def test_what_has_a_sign_may_be_negative(varied: Variations) -> None:
    assert counterexample(varied, LEFT, is_light, WIDTH, signed=True) is None


@pytest.mark.parametrize("signed", [True, False])
def test_a_root_of_what_is_negative_has_no_value(varied: Variations, signed: bool) -> None:
    found = counterexample(varied, Root(LEFT), is_light, WIDTH, signed=signed)
    assert found is not None
    assert 3.0 < found.values["m"] < 4.0


@pytest.mark.parametrize("formula", [LEFT, Root(Symbol("d"))])
def test_there_is_none_where_what_is_told_excludes_it(varied: Variations, formula: Expression) -> None:
    assert counterexample(varied, formula, lambda other: other.values["m"] < 3.0, WIDTH, signed=False) is None


def test_no_answer_is_computed_where_what_is_told_never_holds(varied: Variations) -> None:
    """The block slides down in every scene, so it never moves up."""
    up = MovesOneWay("ramp.blocks.0", "up the slope", ahead=True)
    seen: list[Variation] = []
    assert counterexample(varied, LEFT, lambda other: bool(seen.append(other)), WIDTH, [up], signed=False) is None
    assert len(seen) == 1
    assert varied.having([1.0, 0.5], None, [up]) is None
    assert varied.having([1.0, 0.5], None, [replace(up, ahead=False)]) is not None


def test_the_closest_numbers_are_tried_first(varied: Variations) -> None:
    seen: list[float] = []
    counterexample(varied, LEFT, lambda other: bool(seen.append(other.values["m"] / 2.0)), WIDTH, signed=False)
    assert CLOSEST + SCATTERED < len(seen) <= MAX_SIMULATIONS[0]
    assert max(seen[:CLOSEST]) < 1.7  # though factors reach 3.0
    assert max(seen) > 2.5  # and some are from everywhere


def test_few_are_tried_where_none_has_an_answer_and_none_twice(
    varied: Variations, monkeypatch: pytest.MonkeyPatch
) -> None:
    tried: list[tuple[float, ...]] = []
    monkeypatch.setattr(Variations, "having", lambda _, numbers, *__: tried.append(tuple(numbers)))
    signed = replace(varied, symbols=[replace(held, signed=True) for held in varied.symbols])
    assert counterexample(signed, LEFT, lambda _: True, WIDTH, signed=False) is None
    assert len(tried) == len(set(tried)) == CLOSEST + SCATTERED
    assert any(value < 0.0 for numbers in tried for value in numbers)


def test_what_is_negative_is_tried_before_what_has_no_value(
    varied: Variations, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The formula has no value for half of all numbers near those of the scene, which does not end the search."""
    tried: list[tuple[float, ...]] = []
    monkeypatch.setattr(Variations, "having", lambda _, numbers, *__: tried.append(tuple(numbers)))
    rooted = LEFT * Root(Number(0.51) - Symbol("d"))
    assert counterexample(varied, rooted, lambda _: True, WIDTH, signed=False) is None
    first, last = tried[: CLOSEST + SCATTERED], tried[CLOSEST + SCATTERED :]
    assert len(last) == CLOSEST + SCATTERED
    assert all(mass > 3.0 and distance < 0.51 for mass, distance in first)
    assert all(distance > 0.51 for _, distance in last)
