"""Tests of the simplification of formulas that were inserted into each other."""

import pytest

from sim2reason.solutions.algebra.evaluated import NumericFormula
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.algebra.standard_equations import (
    as_one_fraction,
    as_power,
    found_by_double_angle,
    half_angles,
)

A, B, X = map(Symbol, ("a", "b", "x"))
AT = {"a": 1.5, "b": 0.8, "x": 0.6}
INSIDE = Power(A, 2) + Number(2.0) * B * X


def worked(held: Expression) -> Expression:
    return NumericFormula(held, float(held.value(AT).real))


def test_fractions_in_fractions_become_one() -> None:
    held = A * (B - A * B * X / (A * X + B * X))
    assert as_one_fraction(held, "x").latex() == r"\frac{b^{2} a}{a + b}"


@pytest.mark.parametrize("held", [Power(Root(INSIDE), 2), Power(Root(INSIDE) + A, 2) - Number(2.0) * A * Root(INSIDE)])
def test_the_square_of_a_root_is_what_stands_under_it(held: Expression) -> None:
    found = as_one_fraction(held + X, "x")
    assert r"\sqrt" not in found.latex()
    assert found.value(AT) == pytest.approx((held + X).value(AT))


def test_what_is_proportional_to_a_power_has_one_number() -> None:
    found = as_power(A * Power(X, 2) / B + B * Power(X, 2), "x", worked)
    assert found is not None
    assert found.latex() == r"2.6750\,x^{2}"
    assert as_power(A * X + B, "x", worked) is None
    assert as_power(A * X / (B + X), "x", worked) is None


def test_an_angle_found_by_its_double_is_seen() -> None:
    squares = A * Power(Call("cos", X), 2) + B * Power(Call("sin", X), 2)
    assert found_by_double_angle(squares, Call("arccos", A) / Number(2.0), "x")
    assert not found_by_double_angle(A * Call("cos", X), Call("arccos", A), "x")
    for left, right in half_angles("x"):
        assert left.value(AT) == pytest.approx(right.value(AT))
