"""Tests that formulas have no nested fractions and nothing left to cancel, and keep their values."""

from math import isclose

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.scenes.dsl.body import BODIES
from sim2reason.scenes.dsl.connection import CONNECTIONS
from sim2reason.scenes.dsl.entity import ENTITIES
from sim2reason.scenes.dsl.model import field_types
from sim2reason.solutions.algebra.expressions import ONE, Expression, Number, Quotient, Sum, Symbol
from sim2reason.solutions.algebra.functions import PI, Absolute, Call, Power, Root
from sim2reason.solutions.algebra.plain_latex import has_nested_fraction, plain_latex, without_nested_fractions
from sim2reason.solutions.algebra.transformations import factors_of, has_fraction, never_negative

M, K, V, G, R, X, Y, D = (Symbol(name) for name in ("m", "k", "v", "g", "R", "x", "y", "d"))
MU, HEAVY = Symbol(r"\mu"), Symbol("M")
AT = {"m": 1.3, "k": 2.1, "v": 0.7, "g": 9.8, "R": 0.3, "x": 0.4, "y": -1.2, "d": 0.8, r"\mu": 0.31, "M": 5.0}


@pytest.mark.parametrize(
    ("held", "written"),
    [
        (Quotient(K * V, Root(K / M)), r"v \sqrt{k m}"),
        (Quotient(Root(K / M), 2.0 * PI), r"\frac{1}{2\,\pi} \sqrt{\frac{k}{m}}"),
        (Quotient(R * V - MU * G * Root((2.0 * D) / (MU * G)), R), r"\frac{R v - \sqrt{2\,d \mu g}}{R}"),
        (Quotient(V, D * Root(K / M)), r"\frac{v}{d} \sqrt{\frac{m}{k}}"),
        (Quotient(ONE, Quotient(Number(2.0), R) - Quotient(V, MU)), r"\frac{R \mu}{2\,\mu - v R}"),
        (Quotient(M * M * X, HEAVY + M), r"\frac{m^{2} x}{M + m}"),
        (
            Quotient(D * D * M, Number(5.0 / 24.0) * Power(R, 2) + Number(1.0 / 12.0) * Power(D, 2)),
            r"\frac{24\,d^{2} m}{5\,R^{2} + 2\,d^{2}}",
        ),
        (M + HEAVY - (Quotient(M * M, M + HEAVY)), r"m + M - \frac{m^{2}}{m + M}"),  # which has one storey
        (V + V - X, r"2\,v - x"),
        (Quotient(7.0 * Power(R, 2) * V, 25.0 * MU * R), r"\frac{7\,R v}{25\,\mu}"),
        (Power(Quotient(M * Root((2.0 * K) / X), HEAVY), 2), r"\frac{2\,m^{2} k}{M^{2} x}"),
        (Quotient(Call("cos", V / X), M), r"\frac{\cos\left(\frac{v}{x}\right)}{m}"),
        (Root(-(D * (X - Y)) / M), r"\sqrt{\frac{d \left(y - x\right)}{m}}"),
    ],
)
def test_a_formula_is_written_as_one_fraction(held: Expression, written: str) -> None:
    found = without_nested_fractions(held)
    assert found.latex() == written
    try:
        value = held.value(AT)
    except ValueError:
        return
    assert found.value(AT) == pytest.approx(value)


def test_a_relation_is_written_so_though_its_tree_is_not() -> None:
    assert plain_latex(Quotient(V, Quotient(X, M))) == r"\frac{v m}{x}"
    assert plain_latex(M * M * G) == "m^{2} g"
    assert plain_latex(Quotient(7.0 * Power(R, 2) * V, 25.0 * MU * G * R)) == r"\frac{7\,R v}{25\,\mu g}"


def _grown(inner: st.SearchStrategy[Expression]) -> st.SearchStrategy[Expression]:
    pairs = st.tuples(inner, inner)
    return st.one_of(
        pairs.map(lambda both: both[0] + both[1]),
        pairs.map(lambda both: both[0] - both[1]),
        pairs.map(lambda both: both[0] * both[1]),
        pairs.map(lambda both: Quotient(*both)),
        inner.map(Root),
        inner.map(Absolute),
        inner.map(lambda held: Call("cos", held)),
        st.tuples(inner, st.integers(2, 3)).map(lambda held: Power(*held)),
    )


ATOMS = st.sampled_from([M, K, V, X, Y, Number(2.0), Number(0.5), Number(5.0 / 24.0), PI])
TREES = st.recursive(ATOMS, _grown, max_leaves=9)


@given(TREES)
def test_any_formula_keeps_its_value(held: Expression) -> None:
    try:
        value = held.value(AT)
    except (ValueError, ArithmeticError):
        return
    assert isinstance(value, float)
    if 1e-3 < abs(value) < 1e6:  # not what rounding has left of a difference
        found = without_nested_fractions(held)
        assert isclose(found.value(AT).real, value, rel_tol=1e-6)


@given(TREES)
def test_no_fraction_stands_in_a_fraction_but_for_roots_in_a_sum_below(held: Expression) -> None:
    try:
        held.value(AT)
    except (ValueError, ArithmeticError):
        return  # over a difference of equal terms there is nothing to write
    found = without_nested_fractions(held)
    assert not has_nested_fraction(found) or _has_sum_of_roots(found)


def _has_sum_of_roots(held: Expression) -> bool:
    """Return whether a root or modulus of a fraction is a term of a sum, which has no common denominator."""
    if isinstance(held, Sum):
        bases = [base for term in held.terms for base in factors_of(term).powers]
        if any(isinstance(base, Root | Absolute | Sum) and has_fraction(base) for base in bases):
            return True
    return any(map(_has_sum_of_roots, held.parts))


def test_no_scene_may_have_a_negative_number_under_a_letter_that_is_never_negative() -> None:
    models = (*BODIES.values(), *ENTITIES.values(), *CONNECTIONS.values())
    fields = [held for model in models for held in field_types(model).values() if held.measure is not None]
    assert {r"\mu", "m", "k", "R", "d"} <= {held.measure.symbol for held in fields if held.measure is not None}
    for held in fields:
        assert held.measure is not None
        assert held.least >= 0.0 or not never_negative(Symbol(held.measure.symbol)), held.measure
    assert not any(never_negative(Symbol(letter)) for letter in ("x", "v", "q", r"\theta", r"\omega"))
