"""Tests of elliptic integrals as formulas, against their definition, tables and each other."""

from math import gamma, pi, sin, sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.solutions.algebra.evaluated import Amplitude, CompleteElliptic, IncompleteElliptic, is_special
from sim2reason.solutions.algebra.expressions import Number, Symbol

THETA, K, U = Symbol(r"\theta"), Symbol("k"), Symbol("u")
POINTS = 4001  # of Simpson's rule


def integrated(angle: float, modulus: float) -> float:
    """Return ∫ dθ/√(1 − k² sin² θ) by Simpson's rule."""
    width = angle / (POINTS - 1)
    values = [1.0 / sqrt(1.0 - (modulus * sin(n * width)) ** 2) for n in range(POINTS)]
    return width / 3.0 * (values[0] + values[-1] + 4.0 * sum(values[1:-1:2]) + 2.0 * sum(values[2:-1:2]))


def test_the_lemniscate() -> None:
    """The value is K(1/√2) = Γ(1/4)²/(4 √π) (Abramowitz and Stegun, 17.3.9)."""
    found = CompleteElliptic(K).value({"k": sqrt(0.5)})
    assert found == pytest.approx(gamma(0.25) ** 2 / (4.0 * sqrt(pi)), rel=1e-14)


@given(st.floats(0.0, 7.0), st.floats(0.0, 0.95))
def test_the_incomplete_integral(angle: float, modulus: float) -> None:
    found = IncompleteElliptic(THETA, K).value({THETA.name: angle, "k": modulus})
    assert found == pytest.approx(integrated(angle, modulus), rel=1e-8, abs=1e-12)


@given(st.floats(-9.0, 9.0), st.floats(0.0, 0.999))
def test_the_amplitude_is_the_inverse(angle: float, modulus: float) -> None:
    integral = float(IncompleteElliptic(THETA, K).value({THETA.name: angle, "k": modulus}).real)
    assert Amplitude(U, K).value({"u": integral, "k": modulus}) == pytest.approx(angle, rel=1e-12, abs=1e-12)


@given(st.floats(0.1, 3.0), st.floats(0.05, 0.9))
def test_derivatives_by_an_imaginary_step(angle: float, modulus: float) -> None:
    """The derivative by the angle is the integrand; that by the modulus agrees with a difference quotient."""
    held, at = IncompleteElliptic(THETA, K), {THETA.name: angle, "k": modulus}
    by_angle = complex(held.value(at | {THETA.name: angle + 1e-30j})).imag / 1e-30
    assert by_angle == pytest.approx(1.0 / sqrt(1.0 - (modulus * sin(angle)) ** 2), rel=1e-12)
    by_modulus = complex(held.value(at | {"k": modulus + 1e-30j})).imag / 1e-30
    step = 1e-6
    above, below = (float(held.value(at | {"k": modulus + side * step}).real) for side in (1.0, -1.0))
    assert by_modulus == pytest.approx((above - below) / (2.0 * step), rel=1e-4, abs=1e-8)


def test_no_integral_for_a_modulus_of_one() -> None:
    with pytest.raises(ValueError, match="elliptic integral of the modulus 1"):
        CompleteElliptic(Number(1.0)).value({})


def test_a_formula_says_that_it_needs_a_special_function() -> None:
    assert is_special(Number(2.0) * CompleteElliptic(K) / U)
    assert not is_special(Number(2.0) * K / U)
