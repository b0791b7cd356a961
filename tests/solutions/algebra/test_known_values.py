"""Tests of formulas with numbers in place of known symbols."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.solutions.algebra.evaluated import Chain, NumericFormula, NumericRoot
from sim2reason.solutions.algebra.expressions import Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.algebra.known_values import with_known_values

A, B, U, V, W, X = (Symbol(name) for name in "abuvwx")
CHAIN = Chain(
    (
        ("u", A * B / (A + B) + Root(Power(A, 2) + B)),
        ("v", U * B * X * A / (U + A + X) - Call("sin", U * X)),
        ("w", NumericFormula(U + V, 1.0) * Number(0.3) * V + NumericRoot(Power(U, 2) - Symbol("y"), "y", 1.0)),
    )
)


@given(*[st.floats(0.1, 9.0)] * 3)
def test_the_value_is_the_same_to_the_last_digit(a: float, b: float, x: float) -> None:
    at = {"a": a, "b": b, "x": 2.0}
    plain = with_known_values(CHAIN, at, "x")
    assert plain.value({**at, "x": x}) == CHAIN.value({**at, "x": x})
    assert set(plain.symbols()) == {"x"}


def test_a_known_part_without_a_value_raises_an_error() -> None:
    with pytest.raises(ValueError, match="math domain error"):
        with_known_values(Chain((("u", Root(A) * X),)), {"a": -1.0, "x": 1.0}, "x")
