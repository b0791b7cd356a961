"""Tests of answers recomputed from solutions' data: closed forms, and refusal of incomplete data."""

import json
from math import cos, isclose, pi, sin, sqrt

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.solutions.checking import recompute
from solution_data import Data, relation, solution, step

ATWOOD = {"m_A": 3.0, "m_B": 2.0, "g": 9.8}
HANGING = relation(["+", ["*", "m_A", "g"], ["*", -1.0, "T"]], ["*", "m_A", "a"])
RISING = relation(["+", "T", ["*", -1.0, "m_B", "g"]], ["*", "m_B", "a"])
COMBINED = relation(["*", ["+", "m_A", ["*", -1.0, "m_B"]], "g"], ["*", ["+", "m_A", "m_B"], "a"], "derived")
RESULT = relation("a", ["/", ["*", ["+", "m_A", ["*", -1.0, "m_B"]], "g"], ["+", "m_A", "m_B"]], "result")


def atwood(*relations: Data, goal: str = "T") -> Data:
    return solution(ATWOOD, goal, step(*relations))


def test_an_elimination() -> None:
    """The answer is T = 2 m_A m_B g/(m_A + m_B), although no relation is solved for T."""
    found = recompute(atwood(HANGING, RISING, COMBINED, RESULT))
    assert not found.faults
    assert found.answer == pytest.approx(2.0 * 3.0 * 2.0 * 9.8 / 5.0, rel=1e-14)


def test_laws_alone_are_solved_together() -> None:
    found = recompute(atwood(HANGING, RISING, goal="a"))
    assert not found.faults
    assert found.answer == pytest.approx(9.8 / 5.0, rel=1e-13)


@pytest.mark.parametrize(
    ("relations", "fault"),
    [
        ((HANGING, COMBINED, RESULT), "do not determine"),
        ((HANGING, RISING, relation("a", 1.97, "result")), "does not hold"),
        ((HANGING, relation(["+", "T", ["*", "m_B", "g"]], ["*", "m_B", "a"]), COMBINED, RESULT), "does not hold"),
        ((HANGING, RISING, relation("a", ["/", "F", "m_A"], "result")), "does not follow"),
        ((RISING, relation("a", 1.96, "result")), "has no value"),
        ((HANGING, RISING, relation("a", 1.96, "integrated")), "has the role integrated"),
    ],
)
def test_what_is_refused(relations: tuple[Data, ...], fault: str) -> None:
    assert any(fault in said for said in recompute(atwood(*relations)).faults)


@pytest.mark.parametrize("name", ATWOOD)
def test_a_given_left_out(name: str) -> None:
    data = atwood(HANGING, RISING, COMBINED, RESULT)
    del data["givens"][name]
    assert recompute(data).faults


def test_a_given_that_cancels_where_forces_balance() -> None:
    """With m_A = m_B, a = 0 for any g; a coefficient of the size of rounding errors does not determine g."""
    balanced = relation("m_A", ["/", ["*", "m_B", ["sin", "\\beta"]], ["sin", "\\theta"]], "result")
    slope = relation(
        ["+", ["*", "m_A", "g", ["sin", "\\theta"]], ["*", -1.0, "m_B", "g", ["sin", "\\beta"]]],
        ["*", ["+", "m_A", "m_B"], "a"],
    )
    data = solution(
        {"m_B": 2.3, "g": 9.8, "\\theta": 0.3, "\\beta": 0.7}, "m_A", step(slope, relation("a", 0.0), balanced)
    )
    assert not recompute(data).faults
    del data["givens"]["g"]
    assert "g has no value" in recompute(data).faults


def test_products_of_two_unknowns_are_not_linear() -> None:
    """Neither law determines x or y alone; the results select one of the two solutions."""
    laws = relation(["*", "x", "y"], 6.0), relation(["+", "x", "y"], 5.0)
    results = relation("x", ["+", 1.0, "z"], "derived"), relation("y", ["*", 2.0, "z"], "derived")
    assert {"x has no value", "y has no value"} <= {*recompute(solution({"z": 1.0}, "x", step(*laws))).faults}
    found = recompute(solution({"z": 1.5}, "x", step(*laws, *results)))
    assert found.answer == pytest.approx(2.5)
    assert found.faults


def projectile(speed: float, angle: float, height: float) -> Data:
    rise, fall = ["*", "v", ["sin", "\\theta"]], ["*", 0.5, "g", ["^", "t", 2.0]]
    root = ["sqrt", ["+", ["^", rise, 2.0], ["*", 2.0, "g", "h"]]]
    return solution(
        {"v": speed, "\\theta": angle, "h": height, "g": 9.8},
        "x",
        step(relation(0.0, ["+", "h", ["*", rise, "t"], ["*", -1.0, fall]])),
        step(relation("t", ["/", ["+", rise, root], "g"], "result")),
        step(relation("x", ["*", "v", ["cos", "\\theta"], "t"])),
    )


@given(st.floats(0.5, 50.0), st.floats(0.05, 1.5), st.floats(0.1, 100.0))
def test_a_projectile(speed: float, angle: float, height: float) -> None:
    found = recompute(projectile(speed, angle, height))
    time = (speed * sin(angle) + sqrt((speed * sin(angle)) ** 2 + 2.0 * 9.8 * height)) / 9.8
    assert not found.faults
    assert found.answer is not None
    assert isclose(found.answer, speed * cos(angle) * time, rel_tol=1e-12)


def test_a_result_for_which_no_law_is_stated() -> None:
    data = projectile(10.0, 0.5, 2.0)
    del data["steps"][0]
    assert any("does not follow" in said for said in recompute(data).faults)


def thrown_down(height: float) -> Data:
    """Return a solution for the height from the speed at the ground, v² = u² + 2 g h with h unknown."""
    return solution(
        {"u": 3.0, "v": sqrt(9.0 + 2.0 * 9.8 * height), "g": 9.8},
        "h",
        step(relation("w", ["*", "g", "h"])),
        step(relation("v", ["sqrt", ["+", ["^", "u", 2.0], ["*", 2.0, "w"]]])),
        step(relation("h", ["solve", float(f"{height:.4e}")], "result")),
    )


def test_a_number_that_follows_from_a_given_result() -> None:
    found = recompute(thrown_down(1.23456789))
    assert not found.faults
    assert found.answer == pytest.approx(1.23456789, rel=1e-13)


def test_a_number_that_follows_from_no_given_result() -> None:
    data = thrown_down(1.23456789)
    del data["steps"][1]
    assert any("no relation determines h" in said for said in recompute(data).faults)
    other = thrown_down(1.23456789)
    other["steps"][2]["relations"][0]["right"][1] *= 1.001
    assert any("0 values of h" in said for said in recompute(other).faults)


def falling_with_friction(near: float, residual: Data | None = None) -> Data:
    """Return a solution for the root of t − 1 + e^(−t) = ½."""
    equation = relation(["+", "t", -1.0, ["exp", ["*", -1.0, "t"]]], "c")
    stated = residual or ["+", "t", -1.0, ["exp", ["*", -1.0, "t"]], ["*", -1.0, "c"]]
    return solution({"c": 0.5}, "t", step(equation), step(relation("t", ["root", "t", stated, near], "result")))


def test_a_root_that_is_said_to_five_digits() -> None:
    found = recompute(falling_with_friction(1.1983))
    assert not found.faults
    assert found.answer is not None
    assert found.answer - 1.0 + np.exp(-found.answer) == pytest.approx(0.5, abs=1e-15)


def test_a_root_that_is_elsewhere_or_of_another_equation() -> None:
    assert recompute(falling_with_friction(1.21)).faults
    assert recompute(falling_with_friction(1.1983, ["+", "t", -1.1983])).faults


def test_two_roots_where_one_is_stated() -> None:
    """Both 1 and 1.00005 are zeros, which five digits do not distinguish."""
    quadratic = ["*", ["+", "x", -1.0], ["+", "x", ["*", -1.0, "b"]]]
    data = solution(
        {"b": 1.00005},
        "x",
        step(relation(quadratic, 0.0)),
        step(relation("x", ["root", "x", quadratic, 1.0], "result")),
    )
    assert any("not the only one" in said for said in recompute(data).faults)
    data["givens"]["b"] = 1.01
    assert not recompute(data).faults


def test_a_number_that_stands_for_a_formula() -> None:
    def data(number: float) -> Data:
        return solution({"m": 3.0, "F": 6.0}, "a", step(relation("F", ["*", ["worked", ["*", 2.0, "m"], number], "a"])))

    assert recompute(data(6.0)).answer == pytest.approx(1.0)
    assert not recompute(data(6.0)).faults
    assert recompute(data(6.42)).faults


def test_degrees_and_counts() -> None:
    angle = solution({"x": 0.5}, "a", step(relation("a", ["arcsin", "x"])), scale=180.0 / pi)
    assert recompute(angle).answer == pytest.approx(30.0, rel=1e-14)
    count = solution({"x": 1.5}, "n", step(relation("n", ["*", 2.0, "x"])), whole=True)
    assert not recompute(count).faults
    count["givens"]["x"] = 1.6
    assert any("a count" in said for said in recompute(count).faults)


def test_what_is_assumed_is_verified() -> None:
    """The stated value of µN − F is checked, although no other relation uses it."""
    spare = ["+", ["*", "\\mu", "N"], ["*", -1.0, "F"]]
    data = solution({"\\mu": 0.5, "N": 10.0, "F": 3.0}, "F", step(relation("S", spare, "verified")))
    assert not recompute(data).faults
    wrong = solution({"\\mu": 0.5, "N": 10.0, "F": 3.0}, "F", step(relation(spare, 2.1, "verified")))
    assert recompute(wrong).faults


@pytest.mark.parametrize(
    "tree",
    [["%", "x", 2.0], ["sin"], ["^", "x", "x"], [], ["+", "x", float("nan")], ["solve", 1.0], [["+"], 1.0]],
)
def test_what_is_no_formula(tree: object) -> None:
    data = solution({"x": 1.0}, "y", step(relation("y", ["*", 2.0, tree])))  # type: ignore[list-item]
    found = recompute(data)
    assert found.answer is None
    assert found.faults


def test_data_of_another_form_or_too_large() -> None:
    assert recompute({"goal": "x"}).faults
    deep: object = "x"
    for _ in range(5000):
        deep = ["sin", deep]
    assert recompute(solution({"x": 1.0}, "y", step(relation("y", deep)))).faults  # type: ignore[arg-type]
    many = [relation(f"x_{n + 1}", f"x_{n}") for n in range(3000)]
    assert recompute(solution({"x_0": 1.0}, "x_1", step(*many))).faults


def test_files_keep_it() -> None:
    data = atwood(HANGING, RISING, COMBINED, RESULT)
    assert recompute(json.loads(json.dumps(data))) == recompute(data)
