"""Tests of signs in formulas: none cancel, none precede a reversible difference, and values are equal."""

import pytest

from sim2reason.solutions.algebra.evaluated import NumericFormula
from sim2reason.solutions.algebra.expressions import (
    ONE,
    Expression,
    Number,
    Quotient,
    Sum,
    Symbol,
    multiply_factors,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import Call, Power, with_plain_signs
from sim2reason.solutions.solution import Relation

A, B, D, X = map(Symbol, ("a", "b", "d", "x_0"))
AT = {"a": 0.7, "b": 1.1, "d": 0.3, "x_0": -0.9, "q": 0.4}


@pytest.mark.parametrize(
    ("held", "written"),
    [
        (sum_terms(ONE, multiply_factors(Number(-1.0), Quotient(-D, X))), r"1 + \frac{d}{x_0}"),
        (Quotient(-D, A - B), r"\frac{d}{b - a}"),
        (multiply_factors(Number(-1.0), Quotient(D, A - B)), r"\frac{d}{b - a}"),
        (Power(multiply_factors(Number(-1.0), Quotient(-D, X)), 2), r"\left(\frac{d}{x_0}\right)^{2}"),
        (D - Call("arctan", -A), r"d + \arctan a"),
        (
            sum_terms(-D, multiply_factors(Number(-1.0), multiply_factors(NumericFormula(-A, -0.7), B))),
            r"0.70000\,b - d",
        ),
        (Quotient(Sum((-A, -B)), D), r"-\frac{a + b}{d}"),
        (A - B, r"a - b"),
    ],
)
def test_a_formula_is_written_with_plain_signs(held: Expression, written: str) -> None:
    found = with_plain_signs(held)
    assert found.latex() == written
    assert found.value(AT) == pytest.approx(held.value(AT))


def test_relations_are_written_so() -> None:
    assert Relation(Symbol("t"), Quotient(-D, A - B), "law").latex() == r"$t = \frac{d}{b - a}$"
