"""Eigenvalues and eigenvectors of small matrices, and eigenmodes of damped linear motions."""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction

import numpy as np
import numpy.typing as npt

from sim2reason.scenes.dsl.state import Array

Complex = npt.NDArray[np.complex128]
Exact = Sequence[Sequence[Fraction]]

NEWTON_ITERATIONS = 4  # Newton iterations; each doubles the number of digits
MAX_CORRECTION_RTOL = (
    1e-6  # fraction of the largest eigenvalue: a larger Newton correction has converged to another eigenvalue
)


def rounded(matrix: Exact) -> Array:
    """Return the matrix, rounded to floating-point numbers."""
    return np.array([[float(part) for part in row] for row in matrix])


def eigenpairs(matrix: Exact) -> tuple[Complex, Complex]:
    """Return the eigenvalues (n,) and eigenvectors, one per column (n, n).

    Each pair is found by LAPACK and improved by Newton's iteration for A x = λ x and v · x = v · v, v being the first
    x, with residuals in rational numbers: J. Dongarra, C. Moler, J. Wilkinson, Improving the accuracy of computed
    eigenvalues and eigenvectors (1983). One that has the same eigenvalue as another stays as it is.
    """
    plain = rounded(matrix)
    decomposition = np.linalg.eig(plain)
    rates, ways = np.asarray(decomposition[0], np.complex128), np.asarray(decomposition[1], np.complex128)
    largest = float(np.abs(rates).max())
    pairs = [
        _improved(matrix, plain, rates[number], ways[:, number], MAX_CORRECTION_RTOL * largest)
        for number in range(len(rates))
    ]
    return np.array([rate for rate, _ in pairs]), np.array([vector for _, vector in pairs]).T


def _improved(matrix: Exact, plain: Array, rate: complex, vector: Complex, shift: float) -> tuple[complex, Complex]:
    n, first = len(vector), vector.conj()
    best, smallest = (rate, vector), np.inf
    for _ in range(NEWTON_ITERATIONS):
        residual = _residual(matrix, rate, vector)
        size = float(np.abs(residual).max())
        if not size < smallest or abs(rate - best[0]) > shift:
            break
        best, smallest = (rate, vector), size
        bordered = np.zeros((n + 1, n + 1), np.complex128)
        bordered[:n, :n], bordered[:n, n], bordered[n, :n] = plain - rate * np.eye(n), -vector, first
        try:
            change = np.linalg.solve(bordered, np.append(residual, 0.0))
        except np.linalg.LinAlgError:
            break
        if not np.isfinite(change).all():
            break
        rate, vector = complex(rate + change[n]), vector + change[:n]
    return best


def _residual(matrix: Exact, rate: complex, vector: Complex) -> Complex:
    """Return the residual λ x − A x, rounded once."""
    real, imaginary = _exact(vector.real), _exact(vector.imag)
    a, b = Fraction(float(rate.real)), Fraction(float(rate.imag))
    residual: list[complex] = []
    for row, x, y in zip(matrix, real, imaginary, strict=True):
        along, across = a * x - b * y - _product(row, real), a * y + b * x - _product(row, imaginary)
        residual.append(complex(float(along), float(across)))
    return np.array(residual)


def _exact(values: Array) -> list[Fraction]:
    return [Fraction(value) for value in values.tolist()]


def _product(row: Sequence[Fraction], values: Sequence[Fraction]) -> Fraction:
    return sum((part * value for part, value in zip(row, values, strict=True) if part), Fraction())


ZERO_RATE_RTOL = 1e-13  # fraction of the largest rate: a smaller rate counts as zero
MAX_CONDITION_NUMBER = 1e8  # largest condition number of the eigenvectors; at critical damping they do not form a basis
REST_SPEED = 1e-11  # m/s or rad/s; a slower motion counts as rest


@dataclass(frozen=True)
class DampedModes:
    """Eigenmodes z of coordinates and rates x = `rest` + Re(`ways` z), with z = `begins` exp(`rates` t)."""

    time: float
    start: Array  # x, (2n,)
    rest: Array  # (2n,)
    ways: Complex  # a column for each mode, (2n, 2n)
    rates: Complex  # 1/s
    begins: Complex

    @property
    def fastest(self) -> float:
        """Return the largest absolute rate of a mode, 1/s."""
        return float(np.abs(self.rates).max())

    def at(self, times: Array) -> Array:
        """Return the coordinates and rates at times (m,), of shape (m, 2n)."""
        decayed = self.begins * np.exp(np.multiply.outer(times - self.time, self.rates))
        return self.rest + np.real(decayed @ self.ways.T)

    def least(self, slopes: Array, span: float) -> Array:
        """Return lower bounds (m,), within `span` seconds, of the changes of functions slopes · (q, q̇), (m, 2n)."""
        weights = (slopes @ self.ways) * self.begins
        real = np.abs(np.imag(self.rates)) <= ZERO_RATE_RTOL * self.fastest
        sinks = np.real(weights) * np.expm1(np.where(real, np.real(self.rates), 0.0) * span)
        bounds: Array = np.where(real, np.minimum(sinks, 0.0), -np.abs(weights) - np.real(weights)).sum(axis=1)
        return bounds

    def accelerations(self, times: Array) -> Array:
        """Return the accelerations at times (m,), of shape (m, n)."""
        n = len(self.start) // 2
        decayed = self.begins * self.rates * np.exp(np.multiply.outer(times - self.time, self.rates))
        return np.real(decayed @ self.ways[n:].T)

    def bend(self, slopes: Array) -> Array:
        """Return upper bounds (m,) of the second time derivatives of the functions slopes · (q, q̇), (m, 2n)."""
        bounds: Array = np.abs((slopes @ self.ways) * self.begins) @ np.abs(self.rates) ** 2
        return bounds

    def moves_until(self, span: float) -> float:
        """Return how long within `span`, in s, some speed can still exceed the threshold below which bodies rest."""
        n = len(self.start) // 2
        size = float(np.abs(self.ways[n:] * self.begins).sum())
        slowest = float(-np.real(self.rates).max())
        return min(span, float(np.log(size / REST_SPEED)) / slowest) if size > REST_SPEED else 0.0


def find_damped_modes(time: float, start: Array, slopes: Exact, base: Array) -> DampedModes | None:
    """Return the eigenmodes of a damped motion that all decay; None if one does not or they do not form a basis.

    `slopes` are those of the accelerations with respect to x, (n, 2n), and `base` the accelerations at the start, (n,).
    """
    n, plain = len(base), rounded(slopes)
    size = float(np.abs(np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [plain]]))).max())
    if not size:
        return None
    rates, vectors = eigenpairs(_scaled(slopes, Fraction(size)))
    if (
        np.linalg.cond(vectors) > MAX_CONDITION_NUMBER
        or np.abs(rates).min() <= ZERO_RATE_RTOL * size
        or np.real(rates).max() >= 0.0
    ):
        return None
    ways: Complex = np.repeat([1.0, size], n)[:, None] * vectors
    rest = start.copy()
    rest[:n] -= np.linalg.solve(plain[:, :n], base - plain[:, n:] @ start[n:])
    rest[n:] = 0.0
    begins: Complex = np.asarray(np.linalg.solve(ways, (start - rest).astype(np.complex128)), dtype=np.complex128)
    return DampedModes(time, start, rest, ways, rates, begins)


def _scaled(slopes: Exact, size: Fraction) -> list[list[Fraction]]:
    """Return the matrix A of x' = A x for the coordinates and the rates divided by `size`, an inverse time."""
    n = len(slopes)
    above = [[size * (column == n + row) for column in range(2 * n)] for row in range(n)]
    return [*above, *([*(part / size for part in row[:n]), *row[n:]] for row in slopes)]
