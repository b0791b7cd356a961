"""Tests of factoring out common terms, without a change of values."""

from math import isclose

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.solutions.algebra.expressions import (
    Expression,
    Number,
    Product,
    Quotient,
    Sum,
    Symbol,
    multiply_factors,
    ratio,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.closed_forms.gathering import factor_terms, with_factors_in_front
from sim2reason.solutions.closed_forms.rewriting import latex_length
from sim2reason.solutions.closed_forms.tidying import tidy

A, B, C, D, G, MU = (Symbol(name) for name in ("m_A", "m_B", "m_C", "m_D", "g", r"\mu"))
SIN, COS = (Call(name, Symbol(r"\theta")) for name in ("sin", "cos"))
AT = {"m_A": 1.3, "m_B": 0.7, "m_C": 2.1, "m_D": 0.4, "g": 9.8, r"\mu": 0.3, r"\theta": 0.5}
SLOPE = A * G * SIN + B * G * SIN - MU * A * G * COS - MU * B * G * COS


@pytest.mark.parametrize(
    ("held", "latex"),
    [
        (SLOPE, r"g \left(m_A + m_B\right) \left(\sin\theta - \mu \cos\theta\right)"),
        (A * G - B * G, "m_A g - m_B g"),  # which is no longer
        (Number(1 / 3) * Power(A, 2) + Number(1 / 3) * Power(A, 2), r"\tfrac{2}{3} m_A^{2}"),
        (A + B - A, "m_B"),
        (
            Power(MU, 2) * Power(COS, 2) * G + Power(SIN, 2) * G - Number(2.0) * MU * COS * SIN * G,
            r"g \left(\mu \cos\theta - \sin\theta\right)^{2}",
        ),
        (
            Number(2.0) * Power(A, 2) + Number(2.0) * Power(B, 2) - Number(4.0) * A * B,
            r"2\,\left(m_A - m_B\right)^{2}",
        ),
        (Power(A, 2) + Power(B, 2) + A * B, r"m_A^{2} + m_B^{2} + m_A m_B"),  # which is no square
        (Number(2.0) * Power(A, 2) + Power(B, 2) + A * B, r"2\,m_A^{2} + m_B^{2} + m_A m_B"),  # nor this
        (
            Quotient(MU * G * COS, A) + Quotient(MU * G * COS, A) * SIN,
            r"\frac{\mu g \cos\theta\,\left(1 + \sin\theta\right)}{m_A}",
        ),
        (Root(SLOPE), r"\sqrt{g \left(m_A + m_B\right) \left(\sin\theta - \mu \cos\theta\right)}"),
    ],
)
def test_what_terms_share_stands_before_them(held: Expression, latex: str) -> None:
    assert factor_terms(held).latex() == latex


@pytest.mark.parametrize(
    ("held", "latex"),
    [
        (A * G - B * G, r"g \left(m_A - m_B\right)"),
        (Number(10.0) * A * G + Number(14.0) * A * C, r"2\,m_A \left(5\,g + 7\,m_C\right)"),
        (Number(0.5) * A + Number(0.25) * B, r"\tfrac{1}{2} m_A + \tfrac{1}{4} m_B"),
        (-A * G - B * G, r"-g \left(m_A + m_B\right)"),
        (A - B, "m_A - m_B"),
        (Quotient(A * G * D, A * B - A * C), r"\frac{g m_D}{m_B - m_C}"),
        (Root(Number(2.0) * A + Number(2.0) * B), r"\sqrt{2\,\left(m_A + m_B\right)}"),
    ],
)
def test_factors_of_all_terms_come_to_the_front(held: Expression, latex: str) -> None:
    assert with_factors_in_front(held).latex() == latex


def formulas() -> st.SearchStrategy[Expression]:
    pairs = st.tuples
    return st.recursive(
        st.sampled_from([A, B, G, MU, SIN, COS, Number(2.0), Number(-0.5)]),
        lambda inner: st.one_of(
            pairs(inner, inner).map(lambda p: sum_terms(*p)),
            pairs(inner, inner).map(lambda p: multiply_factors(*p)),
            pairs(inner, inner).map(lambda p: sum_terms(multiply_factors(p[0], G), multiply_factors(-p[1], G))),
            inner.map(lambda e: Power(e, 2)),
            inner.map(lambda e: Root(sum_terms(Power(e, 2), Number(1.0)))),
            pairs(inner, inner).map(lambda p: ratio(p[0], sum_terms(Power(p[1], 2), Number(1.0)))),
        ),
        max_leaves=8,
    )


@given(formulas())
def test_gathered_and_tidied_formulas_keep_their_value(held: Expression) -> None:
    value = held.value(AT).real
    near = {"rel_tol": 1e-9, "abs_tol": 1e-9 * (1.0 + sum(abs(part.value(AT)) for part in held.parts))}
    assert isclose(factor_terms(held).value(AT).real, value, **near)
    assert isclose(tidy(held).value(AT).real, value, **near)
    assert isclose(with_factors_in_front(held).value(AT).real, value, **near)
    assert latex_length(factor_terms(held)) <= latex_length(held)


def test_signs_leave_sums_of_negative_terms() -> None:
    held = Product((Quotient(-A - B, C), Sum((-A, -B)), D))
    assert tidy(held).latex() == r"\frac{m_D \left(m_A + m_B\right) \left(m_A + m_B\right)}{m_C}"
    assert tidy(Quotient(-A - B, C)).latex() == r"-\frac{m_A + m_B}{m_C}"
    assert tidy(Quotient(A, Quotient(B, C))).latex() == r"\frac{m_A m_C}{m_B}"
    assert tidy(Power(A * Root(B + C), 2)).latex() == r"m_A^{2} \left(m_B + m_C\right)"


@pytest.mark.parametrize(
    ("held", "written"),
    [
        (A * C + A * D + B * C + B * D, r"\left(m_A + m_B\right) \left(m_C + m_D\right)"),
        (A * C + 4.0 * C * D + A * D + B * C + B * D, r"\left(m_A + m_B\right) \left(m_C + m_D\right) + 4\,m_C m_D"),
        (A * A + A * B + A * C + B * C, r"\left(m_A + m_C\right) \left(m_A + m_B\right)"),
        (A * C + A * D + B * C + 2.0 * B * D, r"m_A m_C + m_A m_D + m_B m_C + 2\,m_B m_D"),
    ],
)
def test_a_product_of_two_sums_is_not_left_multiplied_out(held: Expression, written: str) -> None:
    found = factor_terms(held)
    assert isclose(found.value(AT).real, held.value(AT).real)
    assert found.latex() == written
