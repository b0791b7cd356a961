"""Tests of arithmetic solutions of every recipe: operations and answers are right within the tolerance."""

import re
from dataclasses import replace
from math import cos, isclose, radians, sin, sqrt

import numpy as np
import pytest

from sim2reason.datasets.grade import grade
from sim2reason.datasets.items import build_request, make_item
from sim2reason.generation.certified import worked_solution
from sim2reason.generation.recipes import RECIPES
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.solution import Condition, Coordinate, Integration
from sim2reason.training.corpora.arithmetic import SLIPS, add_slips, renumbered
from sim2reason.training.corpora.operations import arithmetic, definitions, format_number, given_values

ROLLING = build_request("rolling", "easy", "numeric", 79, 8, {"state": 100.0}, "SI")


@pytest.mark.parametrize("recipe", list(RECIPES))
def test_arithmetic_leads_to_the_answer(recipe: str) -> None:
    request = build_request(recipe, "easy", "numeric", 4, 1, None, "SI")
    item, found = make_item(request)
    solution = worked_solution(request, found)
    text = arithmetic(solution)
    assert bool(text) <= solution.derived
    assert not text or grade(item, text).reward == 1.0, text


def recalculated(formula: str) -> float:
    """Return the value of a formula from left to right, as in single operations and products of factors."""
    functions = {"sin": lambda x: sin(radians(x)), "cos": lambda x: cos(radians(x)), "sqrt": sqrt}
    total, operator = 0.0, "+"
    for sign, name, number, then in re.findall(r"(-?)(sin|cos|sqrt)?(\d+\.?\d*(?:e-?\d+)?)([-+*/]?)", formula):
        value = functions.get(name, float)(float(number)) * (-1.0 if sign else 1.0)
        total = {"+": total + value, "-": total - value, "*": total * value, "/": total / value}[operator]
        operator = then or "+"
    return total


@pytest.mark.parametrize("index", range(8))
def test_each_operation_is_true_to_three_digits(index: int) -> None:
    """Python recalculates each operation; one without a first number takes the previous result."""
    request, before = replace(ROLLING, index=index), "0"
    text = arithmetic(worked_solution(request, make_item(request)[1])).partition("\n")[0]
    for step in text.split("; "):
        left, _, result = re.sub(r"^[A-Za-z][A-Za-z0-9]*=", "", step).rpartition("=")
        formula = f"{before}{left}" if left[:1] in set("*/+") else left
        assert not formula or isclose(recalculated(formula), float(result), rel_tol=6e-3), step
        before = result


def test_what_is_integrated_is_no_arithmetic() -> None:
    solution = worked_solution(ROLLING, make_item(ROLLING)[1])
    assert arithmetic(solution)
    *others, last = solution.steps
    held, time, zero = Coordinate("s", "v", "a", Number(0.0), Number(0.0)), Symbol("t"), Number(0.0)
    phase = Integration("t", zero, (held,), (), (), Condition(time - Symbol("T")), (("v", solution.goal),))
    integrated = replace(last, integration=phase)
    assert not arithmetic(replace(solution, steps=(*others, integrated)))


def test_large_numbers_have_three_digits_too() -> None:
    assert [format_number(x) for x in (184737.4, -0.000123456, 9.8, 0.0)] == ["1.85e5", "-1.23e-4", "9.80", "0"]


@pytest.mark.parametrize("kind", list(SLIPS))
def test_a_slip_changes_a_formula_and_what_follows_from_it(kind: str) -> None:
    solution = worked_solution(ROLLING, make_item(ROLLING)[1])
    held = definitions(solution)
    wrong = add_slips(held, {kind: 1.0}, np.random.default_rng(0))
    assert [*wrong] == [*held]
    changed = [name for name in held if wrong[name] != held[name]]
    assert len(changed) == 1, "one place"
    assert arithmetic(solution, lambda _: wrong) != arithmetic(solution)


def test_no_slip_without_its_share() -> None:
    held = definitions(worked_solution(ROLLING, make_item(ROLLING)[1]))
    assert add_slips(held, {"sign": 0.0, "term": 0.0}, np.random.default_rng(1)) == held


@pytest.mark.parametrize("seed", range(5))
def test_other_numbers_stand_in_the_text_and_in_the_solution(seed: int) -> None:
    item, found = make_item(ROLLING)
    solution = worked_solution(ROLLING, found)
    other = renumbered(item.prompt, solution, np.random.default_rng(seed))
    assert other is not None
    prompt, changed = other
    assert prompt != item.prompt
    assert re.sub(r"[\d.]+", "#", prompt) == re.sub(r"[\d.]+", "#", item.prompt)
    values = given_values(changed)
    assert values["g"] == given_values(solution)["g"]
    moved = [name for name, value in given_values(solution).items() if values[name] != value]
    assert moved
    for name in moved:
        said = values[name] if name != r"\theta" else np.degrees(values[name])
        assert any(isclose(float(text), abs(said)) for text in re.findall(r"\d+(?:\.\d+)?", prompt)), name
    for name, formula in definitions(changed).items():
        assert isclose(formula.value(changed.values), changed.values[name])
        assert changed.values[name] * solution.values[name] > 0.0, "signs stay"
