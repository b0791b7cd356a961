"""Tests of the equations that are stated before their roots, and of reasons why a root is unique."""

import pytest

from sim2reason.solutions.algebra.closed_roots import roots
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Function, Power, Root
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.algebra.standard_equations import stated_equation, trend

A, T, X, W = map(Symbol, ("a", "t", "x", "w"))
AT = {"a": 1.5, "t": 0.8, "x": 0.6, "w": 2.0}


def test_a_quadratic_equation_is_stated_with_its_unknown_on_the_left() -> None:
    """The equation w = ½ a x² + t x is written with its sides swapped."""
    sides = stated_equation("x", Number(0.5) * A * Power(X, 2) + T * X, W, Polynomial.factored)
    assert sides is not None
    assert [side.latex() for side in sides] == [r"\tfrac{1}{2} a x^{2} + t x", "w"]


def test_an_equation_in_the_sine_and_cosine_of_an_angle_is_stated() -> None:
    sides = stated_equation("x", A * Call("sin", X) - T * Call("cos", X), W, Polynomial.factored)
    assert sides is not None
    left, right = sides
    assert left.value(AT) - right.value(AT) == pytest.approx((A * Call("sin", X) - T * Call("cos", X) - W).value(AT))
    assert right == W


def test_a_factor_that_all_terms_share_is_cancelled() -> None:
    """The equation a w x² + a t x = a² w is divided by a."""
    held = A * W * Power(X, 2) + A * T * X
    sides = stated_equation("x", held, Power(A, 2) * W, Polynomial.factored)
    assert sides is not None
    assert [side.latex() for side in sides] == ["w x^{2} + t x", "w a"]
    found = [root.latex() for root in roots("x", held, Power(A, 2) * W)]
    assert found[0] == r"\frac{\sqrt{t^{2} + 4\,w^{2} a} - t}{2\,w}"


@pytest.mark.parametrize("function", ["sin", "cos"])
def test_a_quadratic_equation_in_a_sine_or_cosine_is_stated(function: Function) -> None:
    atom = Call(function, X)
    sides = stated_equation("x", A * Power(atom, 2) - T * atom, W, Polynomial.factored)
    assert sides is not None
    assert [side.latex() for side in sides] == [rf"a \{function}^{{2}} x - t \{function} x", "w"]


@pytest.mark.parametrize("formula", [A * X, A * Power(X, 2), Call("exp", X) + X])
def test_nothing_is_stated_that_undoing_steps_solves(formula: Symbol) -> None:
    assert stated_equation("x", formula, W, Polynomial.factored) is None


def test_an_equation_with_a_root_is_stated_without_it() -> None:
    """The equation t √x + x = w becomes t² x = (w − x)²."""
    sides = stated_equation("x", T * Root(X) + X, W, Polynomial.factored)
    assert sides is not None
    root = 0.5 * (-0.8 + (0.64 + 8.0) ** 0.5)
    left, right = (side.value({**AT, "x": root**2}) for side in sides)
    assert left == pytest.approx(right)


def test_where_a_formula_falls_or_grows_all_along_it_is_said() -> None:
    """The period of a bound orbit decreases with the mass of the star."""
    period = Root(Power(X / (A * X - T), 3) / X)
    assert trend(period, "x", AT) == "decreases"
    assert trend(A * X, "x", AT) == "increases"
    assert not trend(Call("sin", A * X), "x", AT)
