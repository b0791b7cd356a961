"""Tests of comparisons repeated for another value, including formulas too long to be written out."""

import pytest

from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol, multiply_factors, sum_terms
from sim2reason.solutions.laws.nested import verify_again
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError, record_inequality

STEPS = 60  # names, each of which has the one before it twice: 2⁶⁰ symbols if all are inserted


def doubled(limit: float) -> SolutionBuilder:
    """Return a builder with a chain of results, each half of twice the previous one, whose last exceeds a limit."""
    book = SolutionBuilder()
    book.state_given("x", 1.0, "")
    last: Expression = Symbol("x")
    step = book.begin_step("doubling")
    for number in range(STEPS):
        name = Symbol(f"a_{{{number}}}")
        half = multiply_factors(Number(0.5), sum_terms(last, last))
        step.add_text(step.result(name, half, "", law=True))
        last = name
    step.close()
    step = book.begin_step("compare")
    record_inequality(book, step, last, Number(limit))
    step.add_text("It exceeds the limit.")
    step.close()
    return book


def test_a_comparison_of_nested_formulas_is_made_again_in_numbers() -> None:
    book = doubled(0.5)
    steps = len(book.steps)
    verify_again(book, "x", Number(0.6), "Now")
    assert len(book.steps) == steps  # such a comparison is not written
    with pytest.raises(UnsolvedError, match="no longer exceeds"):
        verify_again(book, "x", Number(0.4), "Now")
