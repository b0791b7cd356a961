"""Eigenmodes of a linear motion with damping: each is an exponential, of a complex rate if it oscillates."""

from dataclasses import dataclass
from itertools import chain
from math import pi

import numpy as np
import numpy.typing as npt

from sim2reason.dsl.state import Array

STILL = 1e-9  # of the largest rate: less is none
SOUND = 1e8  # condition of the eigenvectors, at most: at critical damping there are too few
REST = 1e-11  # m/s or rad/s; what moves no faster turns back no more
EARLY, LATE = 16, 8  # instants at which is tried whether a motion is linear: of two fast periods, and of the whole
Complex = npt.NDArray[np.complex128]


@dataclass(frozen=True)
class DampedModes:
    """Eigenmodes z of coordinates and rates x = `rest` + Re(`ways` z), with z = `begins` exp(`rates` t)."""

    time: float
    start: Array  # x, (2n,)
    slopes: Array  # of the accelerations with respect to x, (n, 2n)
    base: Array  # the accelerations at the start, (n,)
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

    def changes(self, span: float) -> list[Array]:
        """Return changes of coordinates and rates, (2n,) each, of the size of those during the first `span`, s."""
        early = (2.0 * 2.0 * pi / self.fastest * number / EARLY for number in range(1, EARLY + 1))
        late = (span * number / LATE for number in range(1, LATE + 1))
        found = self.at(self.time + np.array([*chain(early, late)])) - self.start
        return [*found, *-found]

    def accelerations(self, change: Array) -> Array:
        """Return the accelerations after a change of coordinates and rates, (n,)."""
        return self.base + self.slopes @ change

    def load(self, change: Array) -> float:
        """Return the largest share of a coordinate or rate in the accelerations after a change."""
        moved = np.abs(self.start) + np.abs(change)  # since the start of the motion, too, for what rounding leaves
        return float((np.abs(self.base) + np.abs(self.slopes) @ moved).max())

    def moves_until(self, span: float) -> float:
        """Return for how much of `span`, s, some speed can exceed what counts as rest."""
        n = len(self.base)
        size = float(np.abs(self.ways[n:] * self.begins).sum())
        slowest = float(-np.real(self.rates).max())
        return min(span, float(np.log(size / REST)) / slowest) if size > REST else 0.0


def found_damped(time: float, start: Array, slopes: Array, base: Array) -> DampedModes | None:
    """Return the eigenmodes of a damped motion, all of which decay; None if it has none, or too few."""
    n = len(base)
    matrix = np.block([[np.zeros((n, n)), np.eye(n)], [slopes]])
    size = float(np.abs(np.linalg.eigvals(matrix)).max())
    if not size:
        return None
    scale = np.repeat([1.0, size], n)  # rates beside coordinates
    rates, vectors = np.linalg.eig(matrix * scale / scale[:, None])
    if np.linalg.cond(vectors) > SOUND or np.abs(rates).min() <= STILL * size or np.real(rates).max() >= 0.0:
        return None
    ways: Complex = np.asarray(vectors * scale[:, None], dtype=np.complex128)
    rest = start.copy()
    rest[:n] -= np.linalg.solve(slopes[:, :n], base - slopes[:, n:] @ start[n:])
    rest[n:] = 0.0
    begins: Complex = np.asarray(np.linalg.solve(ways, (start - rest).astype(np.complex128)), dtype=np.complex128)
    return DampedModes(time, start, slopes, base, rest, ways, np.asarray(rates, dtype=np.complex128), begins)
