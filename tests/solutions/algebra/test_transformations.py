"""Tests of derivatives and limits of formulas, against difference quotients and distant values."""

import pytest

from sim2reason.solutions.algebra.expressions import ONE, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Absolute, Call, Power, Root
from sim2reason.solutions.algebra.transformations import CancelledError, derivative, limit

X, A = Symbol("x"), Symbol("a")
AT = {"x": 0.37, "a": 1.9}
FORMULAS: tuple[Expression, ...] = (
    A * X + Power(X, 3),
    A / (X + A),
    Root(A + Power(X, 2)) * Call("sin", A * X),
    Call("cos", X) / (Number(2.0) + Call("tan", X)),
    Call("arctan", X / A) + Call("arcsin", X) + Call("arccos", X * X),
    Call("ln", A + X) * Call("exp", X),
    A / Power(X, 2),
)


@pytest.mark.parametrize("formula", FORMULAS, ids=[formula.latex() for formula in FORMULAS])
def test_derivatives_are_those_of_differences(formula: Expression) -> None:
    step = 1e-6
    ahead, behind = (formula.value({**AT, "x": AT["x"] + side * step}).real for side in (1.0, -1.0))
    assert derivative(formula, "x").value(AT) == pytest.approx((ahead - behind) / (2.0 * step), rel=1e-8)


def test_what_does_not_hold_a_symbol_does_not_change() -> None:
    assert derivative(Root(A), "x") == Number(0.0)


def test_no_rule_is_an_error() -> None:
    with pytest.raises(TypeError, match="Absolute"):
        derivative(Absolute(X - A), "x")
    with pytest.raises(TypeError, match="grows or vanishes"):
        limit(Call("sin", X), "x", AT, large=True)


LIMITS: tuple[Expression, ...] = (
    (A * X - ONE) / (X + A),
    Root((Power(X, 2) + A) / (A * Power(X, 2) + X)),
    Call("sin", A * X / (X + ONE)) + A,
    Power((X + A) / (X + ONE), 2) * (A + ONE / X),
    Root(Absolute((ONE - A * X) / (X + A))),
)


@pytest.mark.parametrize("formula", LIMITS, ids=[formula.latex() for formula in LIMITS])
def test_limits_are_values_far_away(formula: Expression) -> None:
    found = limit(formula, "x", AT, large=True)
    assert found is not None
    assert "x" not in found.symbols()
    assert found.value(AT) == pytest.approx(formula.value({**AT, "x": 1e9}).real, rel=1e-8)


def test_limits_where_a_symbol_vanishes() -> None:
    found = limit((A * X + Number(3.0)) / (X + A), "x", AT, large=False)
    assert found is not None
    assert found.value(AT) == pytest.approx(3.0 / AT["a"])


def test_what_grows_or_vanishes_has_no_limit_and_what_cancels_is_not_guessed() -> None:
    assert limit(A * X, "x", AT, large=True) is None
    assert limit(A / X, "x", AT, large=True) is None
    with pytest.raises(CancelledError):
        limit(X + A - X, "x", AT, large=True)
