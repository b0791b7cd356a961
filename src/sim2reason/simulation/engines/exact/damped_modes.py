"""Eigenmodes of a linear motion with damping: each is an exponential, of a complex rate if it oscillates."""

from dataclasses import dataclass
from fractions import Fraction

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.simulation.engines.exact.eigenpairs import Complex, Exact, eigenpairs, rounded

STILL = 1e-13  # of the largest rate: less is none
SOUND = 1e8  # condition of the eigenvectors, at most: at critical damping there are too few
REST = 1e-11  # m/s or rad/s; what moves no faster turns back no more


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
        """Return the largest rate, 1/s."""
        return float(np.abs(self.rates).max())

    def at(self, times: Array) -> Array:
        """Return the coordinates and rates at times (m,), of shape (m, 2n)."""
        decayed = self.begins * np.exp(np.multiply.outer(times - self.time, self.rates))
        return self.rest + np.real(decayed @ self.ways.T)

    def least(self, slopes: Array, span: float) -> Array:
        """Return a bound below the changes in `span`, s, of functions with these slopes (m, 2n), of shape (m,)."""
        weights = (slopes @ self.ways) * self.begins
        real = np.abs(np.imag(self.rates)) <= STILL * self.fastest
        sinks = np.real(weights) * np.expm1(np.where(real, np.real(self.rates), 0.0) * span)
        found: Array = np.where(real, np.minimum(sinks, 0.0), -np.abs(weights) - np.real(weights)).sum(axis=1)
        return found

    def accelerations(self, times: Array) -> Array:
        """Return the accelerations at times (m,), of shape (m, n)."""
        n = len(self.start) // 2
        decayed = self.begins * self.rates * np.exp(np.multiply.outer(times - self.time, self.rates))
        return np.real(decayed @ self.ways[n:].T)

    def bend(self, slopes: Array) -> Array:
        """Return a bound of the second derivatives of functions with these slopes (m, 2n), of shape (m,)."""
        found: Array = np.abs((slopes @ self.ways) * self.begins) @ np.abs(self.rates) ** 2
        return found

    def moves_until(self, span: float) -> float:
        """Return for how much of `span`, s, some speed can exceed what counts as rest."""
        n = len(self.start) // 2
        size = float(np.abs(self.ways[n:] * self.begins).sum())
        slowest = float(-np.real(self.rates).max())
        return min(span, float(np.log(size / REST)) / slowest) if size > REST else 0.0


def found_damped(time: float, start: Array, slopes: Exact, base: Array) -> DampedModes | None:
    """Return the eigenmodes of a damped motion, all of which decay; None if it has none, or too few.

    `slopes` are those of the accelerations with respect to x, (n, 2n), and `base` the accelerations at the start, (n,).
    """
    n, plain = len(base), rounded(slopes)
    size = float(np.abs(np.linalg.eigvals(np.block([[np.zeros((n, n)), np.eye(n)], [plain]]))).max())
    if not size:
        return None
    rates, vectors = eigenpairs(_scaled(slopes, Fraction(size)))
    if np.linalg.cond(vectors) > SOUND or np.abs(rates).min() <= STILL * size or np.real(rates).max() >= 0.0:
        return None
    ways: Complex = np.repeat([1.0, size], n)[:, None] * vectors
    rest = start.copy()
    rest[:n] -= np.linalg.solve(plain[:, :n], base - plain[:, n:] @ start[n:])
    rest[n:] = 0.0
    begins: Complex = np.asarray(np.linalg.solve(ways, (start - rest).astype(np.complex128)), dtype=np.complex128)
    return DampedModes(time, start, rest, ways, rates, begins)


def _scaled(slopes: Exact, size: Fraction) -> list[list[Fraction]]:
    """Return the matrix of the rates of change of coordinates and of rates divided by `size`."""
    n = len(slopes)
    above = [[size * (column == n + row) for column in range(2 * n)] for row in range(n)]
    return [*above, *([*(part / size for part in row[:n]), *row[n:]] for row in slopes)]
