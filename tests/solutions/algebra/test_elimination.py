"""Tests of the elimination of forces from labelled equations of motion."""

import pytest

from sim2reason.solutions.algebra.elimination import Elimination, Equation
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.writing.steps import SolutionBuilder


def solve_atwood() -> SolutionBuilder:
    """Solve T − m₁g = m₁a and m₂g − T = m₂a for a, where only the sum of both is free of T."""
    book = SolutionBuilder()
    for name, value, unit in (("m_1", 1.0, "kg"), ("m_2", 3.0, "kg"), ("g", 9.8, "m/s²")):
        book.state_given(name, value, unit)
    first, second, gravity, rate, tension = (
        Polynomial.from_expression(Symbol(name)) for name in ("m_1", "m_2", "g", "a", "T")
    )
    equations = [
        Equation("(1)", tension - first * gravity, first * rate, rate),
        Equation("(2)", second * gravity - tension, second * rate, rate),
    ]
    Elimination(book, {"a": "m/s²", "T": "N"}).solve(equations, ["a", "T"], ["a"])
    return book


def test_the_solution_depends_on_the_sum_under_the_same_key_each_time() -> None:
    """a = (m₂ − m₁) g/(m₁ + m₂); an address in memory as a key would differ between two solutions held at once."""
    one, other = solve_atwood(), solve_atwood()
    assert one.values["a"] == pytest.approx(4.9, rel=1e-12)
    assert [step.gives for step in one.steps] == [step.gives for step in other.steps]
    combine, solved = one.steps
    assert combine.id in solved.needs
