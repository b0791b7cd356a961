"""Tests of expressions: values, derivatives, LaTeX, and agreement of the LaTeX with the values."""

import pickle
from math import cos, pi, sin, sqrt

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from sim2reason.grading import arithmetic
from sim2reason.grading.parser import parse
from sim2reason.grading.tokens import tokenize
from sim2reason.solutions.algebra.evaluated import NumericFormula, NumericRoot, gradient
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol, multiply_factors, ratio, sum_terms
from sim2reason.solutions.algebra.fractions import reduced_quotient
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.algebra.polynomials import Polynomial, total
from sim2reason.solutions.algebra.rounded_numbers import round_to_digits, rounded_latex

M, A, THETA = Symbol("m_A"), Symbol("a"), Symbol(r"\theta")
AT = {"m_A": 2.5, "a": 1.25, r"\theta": 0.6}


def formulas() -> st.SearchStrategy[Expression]:
    leaves = st.sampled_from([M, A, Call("sin", THETA), Call("cos", THETA), Number(2.0), Number(0.5), Number(-3.0)])
    pairs = st.tuples
    return st.recursive(
        leaves,
        lambda inner: st.one_of(
            pairs(inner, inner).map(lambda p: sum_terms(*p)),
            pairs(inner, inner).map(lambda p: multiply_factors(*p)),
            inner.map(lambda e: -e),
            inner.map(lambda e: Power(e, 2)),
            inner.map(lambda e: Root(sum_terms(Power(e, 2), Number(1.0)))),
            pairs(inner, inner).map(lambda p: ratio(p[0], sum_terms(Power(p[1], 2), Number(1.0)))),
        ),
        max_leaves=6,
    )


@given(formulas())
def test_a_minus_sign_in_front_is_known_before_it_is_written(held: Expression) -> None:
    assert held.negative == held.latex().startswith("-")


@given(formulas())
@example(
    multiply_factors(Number(4.0), ratio(Number(2.0), sum_terms(Power(Number(2.0), 2), Number(1.0))))
)  # no 4 and 2/5
def test_the_grader_reads_what_is_written(held: Expression) -> None:
    table = {"m_A", "a", "theta"}
    node, *_ = parse(tokenize(held.latex(), table), unit_follows=False)
    found = arithmetic.value(node, {"m_A": 2.5, "a": 1.25, "theta": 0.6})
    assert found == pytest.approx(held.value(AT), rel=1e-9, abs=1e-9)


@given(formulas())
def test_derivatives_are_those_of_small_steps(held: Expression) -> None:
    (slope,) = gradient(held, AT, {"a": 0})
    step = 1e-6
    ends = [held.value({**AT, "a": AT["a"] + side * step}).real for side in (1.0, -1.0)]
    assert slope == pytest.approx((ends[0] - ends[1]) / (2.0 * step), rel=1e-5, abs=1e-5 * max(1.0, abs(ends[0])))


def test_a_root_is_refined_and_follows_its_coefficients() -> None:
    held = NumericRoot(sum_terms(Power(Symbol("x"), 2), -A), "x", 1.1)
    assert held.value(AT) == pytest.approx(sqrt(1.25), rel=1e-14)
    assert gradient(held, AT, {"a": 0}) == pytest.approx([0.5 / sqrt(1.25)])


def test_numbers_have_five_digits() -> None:
    assert [rounded_latex(x) for x in (34.8, 0.0, 1.0 / 3.0, -1234567.0)] == [
        "34.800",
        "0",
        "0.33333",
        r"-1.2346 \times 10^{6}",
    ]
    assert NumericFormula(Number(1.0 / 3.0), 1.0 / 3.0).value({}, 5) == round_to_digits(1.0 / 3.0) == 0.33333


def test_sines_and_cosines_of_one_angle_make_one() -> None:
    s, c = (Polynomial.from_expression(Call(name, THETA)) for name in ("sin", "cos"))
    assert (s * s + c * c).number == 1.0
    assert ((s + c) * (s + c) - (s * c).scale(2.0)).number == 1.0


def test_sines_and_cosines_of_two_angles_make_one() -> None:
    s, c = (Polynomial.from_expression(Call(name, THETA)) for name in ("sin", "cos"))
    z, w = (Polynomial.from_expression(Call(name, A)) for name in ("sin", "cos"))
    assert ((s * s + c * c) * (z * z + w * w)).number == 1.0
    assert total([s * s * z * z, s * s * w * w, c * c * z * z, c * c * w * w]).number == 1.0


@given(st.floats(0.1, pi / 2 - 0.1))
def test_what_all_terms_share_stands_in_front(angle: float) -> None:
    m, g = Polynomial.from_expression(M), Polynomial.from_expression(Symbol("g"))
    sine, cosine, mu = (Polynomial.from_expression(x) for x in (Call("sin", THETA), Call("cos", THETA), Symbol(r"\mu")))
    held = (m * g * (sine - mu * cosine)).factored()
    assert held.latex() == r"m_A g \left(\sin\theta - \mu \cos\theta\right)"
    at = {"m_A": 2.0, "g": 9.8, r"\theta": angle, r"\mu": 0.3}
    assert held.value(at) == pytest.approx(2.0 * 9.8 * (sin(angle) - 0.3 * cos(angle)))


def test_no_minus_sign_stands_below_a_fraction_or_under_a_square() -> None:
    x, y = Symbol("x"), Symbol("y")
    assert ((x - y) / -(x + y)).latex() == r"\frac{y - x}{x + y}"
    assert (
        reduced_quotient(
            Polynomial.from_expression(x), (Polynomial.from_expression(x) + Polynomial.from_expression(y)).scale(-1.0)
        ).latex()
        == r"-\frac{x}{x + y}"
    )
    assert Power(-x, 2).latex() == "x^{2}"
    assert Power(-x, 3).latex() == r"\left(-x\right)^{3}"


def test_half_is_no_denominator() -> None:
    assert ((Symbol("x") - Symbol("y")) / Number(0.5)).latex() == r"2\,\left(x - y\right)"


def test_a_number_with_a_power_of_ten_is_raised_in_parentheses() -> None:
    small = NumericFormula(M, 8.3673e-5)
    assert Power(small, 2).latex() == r"\left(8.3673 \times 10^{-5}\right)^{2}"


def test_a_polynomial_has_the_value_of_its_formula_to_the_last_digit() -> None:
    x, y, sine = (
        Polynomial.from_expression(A),
        Polynomial.from_expression(M),
        Polynomial.from_expression(Call("sin", THETA)),
    )
    held = x * x * y.scale(0.3) - sine * sine * y.scale(1.7) + Polynomial({((A, -2), (M, 1)): -2.9, (): 0.1})
    at = {A.name: 0.37, M.name: 1.93, THETA.name: 0.61}
    assert held.value(at) == held.expression().value(at)


def test_a_pickled_formula_leaves_its_kept_hash_behind() -> None:
    """Strings have other hashes in another process."""
    formula = Root(sum_terms(M, Power(A, 2)))
    hash(formula)
    text = formula.latex()
    copied = pickle.loads(pickle.dumps(formula))
    assert copied == formula
    assert copied.kept_hash is None
    assert copied.latex() == text
