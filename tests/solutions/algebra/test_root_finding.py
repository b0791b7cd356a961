"""Tests of solving equations for one symbol, in closed form if possible and else numerically."""

from collections.abc import Mapping

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.algebra.root_finding import evaluate_known_parts, solved_for

A, B, C, X, Y = (Symbol(name) for name in "abcxy")
SINE, COSINE, HALF = Call("sin", X), Call("cos", X), Number(0.5)

CLOSED: Mapping[str, Expression] = {
    "a time of constant acceleration, for the acceleration": (Root(Power(A, 2) + Number(2.0) * X * B) - A) / X,
    "a square root of the symbol beside it": A * X + B * Root(X),
    "two accelerations of one tension, for a mass": X
    * (A * (B + X) / (B * X + C * X + C * B) - ((X + B) * A * (B + X) / (B * X + C * X + C * B) - C * A) / X),
    "a quadratic equation in fractions": A * X / (B + X) + C * X,
    "a power that all terms share": A * Power(X, 3) / (B * Power(X, 2) + C * Power(X, 3)),
    "the square alone": A * Power(Power(X, 2), 2) + B * Power(X, 2),
    "sine and cosine": A * (SINE - B * COSINE) / (A + B),
    "a power of the sine": A * Power(SINE, 2) + B * SINE,
    "both to the second degree": A * SINE * (SINE + B * COSINE),
    "the cosine alone": A * COSINE + B * Power(COSINE, 2),
    "a logarithm": A * Call("ln", B / X),
}


@pytest.mark.parametrize("formula", CLOSED.values(), ids=CLOSED)
@settings(max_examples=15)
@given(st.lists(st.floats(0.3, 3.0), min_size=3, max_size=3), st.floats(0.1, 1.4))
def test_what_has_a_closed_inverse_gets_it(formula: Expression, numbers: list[float], x: float) -> None:
    """Solving y = f(x) for x recovers x, in closed form except near turning points of f."""
    at = dict(zip("abc", numbers, strict=True)) | {"x": x}
    at["y"] = float(formula.value(at).real)
    slope = (formula.value(at | {"x": x * 1.0001}).real - at["y"]) / (1e-4 * x)
    found = solved_for("x", formula, Y, at)
    if abs(slope) > 1e-2:
        assert not isinstance(found, NumericRoot)
    assert found.value(at) == pytest.approx(x, rel=1e-6)


@pytest.mark.parametrize(
    "formula", [X + A * Call("ln", X), SINE + A * X, Power(X, 3) + A * X, SINE * COSINE + A * SINE]
)
def test_what_has_none_is_found_numerically(formula: Expression) -> None:
    at = {"a": 0.7, "x": 0.4}
    found = solved_for("x", formula, Y, at | {"y": float(formula.value(at).real)})
    assert isinstance(found, NumericRoot)


def test_a_long_formula_is_settled_to_numbers_of_what_is_known() -> None:
    formula = A * B * X + (A + B) * Power(X, 2) + C
    at = {"a": 2.0, "b": 3.0, "c": 5.0}
    short = evaluate_known_parts(formula, frozenset({"x"}), lambda held: Number(float(held.value(at).real)))
    assert set(short.symbols()) <= {"x", "c"}
    assert short.value(at | {"x": 0.4}) == pytest.approx(formula.value(at | {"x": 0.4}))


def test_a_fraction_has_no_whole_factor_left() -> None:
    """The solution of 4 a x = 4 b + 2 c x is x = 2 b/(2 a − c)."""
    a, b, c, x = (Symbol(name) for name in "abcx")
    at = {"a": 3.0, "b": 1.0, "c": 2.0, "x": 0.5}
    assert solved_for("x", 4.0 * a * x - 2.0 * c * x, 4.0 * b, at).latex() == r"\frac{2\,b}{2\,a - c}"
