"""Tests of the precision of small eigenvalues beside large ones."""

from fractions import Fraction

import numpy as np
import pytest

from sim2reason.simulation.engines.exact.eigenpairs import eigenpairs


@pytest.mark.parametrize("stiff", [1.0, 1e6, 1e12])
def test_small_eigenvalues_have_all_digits(stiff: float) -> None:
    """Two equal masses on a soft spring, joined by a stiff one, have λ₁ λ₂ = k₁ k₂, λ₁ + λ₂ = k₁ + 2 k₂."""
    k = Fraction(stiff)
    rates, ways = eigenpairs([[k + 1, -k], [-k, k]])
    small, large = sorted(np.real(rates).tolist())
    assert not np.imag(rates).any()
    assert Fraction(small) * Fraction(large) == pytest.approx(k, rel=1e-15)
    assert small + large == pytest.approx(2.0 * stiff + 1.0, rel=1e-15)
    assert np.linalg.matrix_rank(ways) == len(rates)


def test_equal_eigenvalues_keep_vectors_of_their_own() -> None:
    """Two equal uncoupled oscillators have two independent eigenvectors."""
    rates, ways = eigenpairs([[Fraction(4), Fraction(0)], [Fraction(0), Fraction(4)]])
    assert np.real(rates) == pytest.approx([4.0, 4.0], rel=1e-15)
    assert abs(np.linalg.det(ways)) == pytest.approx(1.0)


def test_pairs_of_complex_eigenvalues_are_found() -> None:
    """The eigenvalues are the roots of x² + x/2 + 1."""
    rates, _ = eigenpairs([[Fraction(0), Fraction(1)], [Fraction(-1), Fraction(-1, 2)]])
    assert sorted(rates, key=np.imag) == pytest.approx([-0.25 - 1j * np.sqrt(0.9375), -0.25 + 1j * np.sqrt(0.9375)])
