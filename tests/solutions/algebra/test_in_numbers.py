"""Tests of closed forms for the roots of equations in which all but the unknown are numbers."""

from math import cos, isclose, sin, sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.questions.difficulty import Need
from sim2reason.solutions.algebra.evaluated import Chain
from sim2reason.solutions.algebra.expressions import ONE, Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root, need_of
from sim2reason.solutions.algebra.standard_equations import closed_root

X, M, G = Symbol("x"), Symbol("m"), Symbol("g")
SIZES = st.floats(0.2, 8.0)


@given(SIZES, SIZES)
def test_a_tension_in_which_a_mass_stands_twice_is_a_linear_equation(x: float, m: float) -> None:
    """The tension of two blocks on one string is T = 2 m x g/(m + x)."""
    chain = Chain((("a", G * (X - M) / (X + M)), ("T", M * (G + Symbol("a")))))
    values = {"x": x, "m": m, "g": 9.8, "T": 2.0 * m * x * 9.8 / (m + x)}
    found = closed_root(chain, Symbol("T"), "x", values)
    assert found is not None
    assert need_of(found) == Need.ARITHMETIC
    closed = found.closed.value({})
    assert not isinstance(closed, complex)
    assert isclose(closed, x, rel_tol=1e-6)
    assert isclose(found.value({name: value for name, value in values.items() if name != "x"}).real, x, rel_tol=1e-9)


@given(SIZES, SIZES)
def test_a_speed_at_which_energy_is_lost_is_a_quadratic_equation(x: float, m: float) -> None:
    """The square of v = √(x² g + m x) is quadratic in x; that of √(x² g + m) − x² is of no known form."""
    chain = Chain((("v", Root(Power(X, 2) * G + M * X)),))
    values = {"x": x, "m": m, "g": 9.8, "v": sqrt(9.8 * x**2 + m * x)}
    found = closed_root(chain, Symbol("v"), "x", values)
    assert found is not None
    assert need_of(found) == Need.QUADRATIC
    closed = found.closed.value({})
    assert not isinstance(closed, complex)
    assert isclose(closed, x, rel_tol=1e-6)


@given(st.floats(0.1, 1.2), st.floats(0.05, 0.9))
def test_an_angle_on_a_rough_slope_takes_an_inverse_function(x: float, mu: float) -> None:
    chain = Chain((("a", G * (Call("sin", X) - Symbol("µ") * Call("cos", X))),))
    values = {"x": x, "µ": mu, "g": 9.8, "a": 9.8 * (sin(x) - mu * cos(x))}
    found = closed_root(chain, Symbol("a"), "x", values)
    assert found is not None
    assert need_of(found) == Need.INVERSE_FUNCTION


@pytest.mark.parametrize(
    ("formula", "value"),
    [
        (X - Number(0.5) * Call("sin", X), 1.5 - 0.5 * sin(1.5)),
        (Power(X, 5) + X + ONE, 1.5**5 + 2.5),
        (X + Root(X) + Call("exp", X), 1.5 + sqrt(1.5) + 2.718281828459045**1.5),
    ],
)
def test_where_there_is_none_none_is_found(formula: Expression, value: float) -> None:
    assert closed_root(Chain((("y", formula),)), Symbol("y"), "x", {"x": 1.5, "y": value}) is None
