"""Eigenvalues and eigenvectors of small matrices, accurate to rounding also for small eigenvalues beside large ones."""

from collections.abc import Sequence
from fractions import Fraction

import numpy as np
import numpy.typing as npt

from sim2reason.dsl.state import Array

Complex = npt.NDArray[np.complex128]
Exact = Sequence[Sequence[Fraction]]

ROUNDS = 4  # of Newton's iteration; each doubles the number of digits
SHIFT = 1e-6  # of the largest eigenvalue: Newton's iteration that goes farther goes to another one


def rounded(matrix: Exact) -> Array:
    """Return the matrix of floating-point numbers."""
    return np.array([[float(part) for part in row] for row in matrix])


def eigenpairs(matrix: Exact) -> tuple[Complex, Complex]:
    """Return eigenvalues and eigenvectors, a column for each.

    Each pair is found by LAPACK and improved by Newton's iteration for A x = λ x and v · x = v · v, v being the first
    x, with residuals in rational numbers: J. Dongarra, C. Moler, J. Wilkinson, Improving the accuracy of computed
    eigenvalues and eigenvectors (1983). One that has the same eigenvalue as another stays as it is.
    """
    plain = rounded(matrix)
    found = np.linalg.eig(plain)
    rates, ways = np.asarray(found[0], np.complex128), np.asarray(found[1], np.complex128)
    largest = float(np.abs(rates).max())
    pairs = [_improved(matrix, plain, rates[number], ways[:, number], SHIFT * largest) for number in range(len(rates))]
    return np.array([rate for rate, _ in pairs]), np.array([way for _, way in pairs]).T


def _improved(matrix: Exact, plain: Array, rate: complex, way: Complex, shift: float) -> tuple[complex, Complex]:
    n, first = len(way), way.conj()
    best, least = (rate, way), np.inf
    for _ in range(ROUNDS):
        residual = _residual(matrix, rate, way)
        size = float(np.abs(residual).max())
        if not size < least or abs(rate - best[0]) > shift:
            break
        best, least = (rate, way), size
        bordered = np.zeros((n + 1, n + 1), np.complex128)
        bordered[:n, :n], bordered[:n, n], bordered[n, :n] = plain - rate * np.eye(n), -way, first
        try:
            change = np.linalg.solve(bordered, np.append(residual, 0.0))
        except np.linalg.LinAlgError:
            break
        if not np.isfinite(change).all():
            break
        rate, way = complex(rate + change[n]), way + change[:n]
    return best


def _residual(matrix: Exact, rate: complex, way: Complex) -> Complex:
    """Return λ x − A x, rounded once."""
    real, imaginary = _exact(way.real), _exact(way.imag)
    a, b = Fraction(float(rate.real)), Fraction(float(rate.imag))
    found: list[complex] = []
    for row, x, y in zip(matrix, real, imaginary, strict=True):
        along, across = a * x - b * y - _product(row, real), a * y + b * x - _product(row, imaginary)
        found.append(complex(float(along), float(across)))
    return np.array(found)


def _exact(values: Array) -> list[Fraction]:
    return [Fraction(value) for value in values.tolist()]


def _product(row: Sequence[Fraction], values: Sequence[Fraction]) -> Fraction:
    return sum((part * value for part, value in zip(row, values, strict=True) if part), Fraction())
