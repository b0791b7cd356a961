"""Eigenmode solution of long intervals of linear motion for which an integrator would need too many steps.

If accelerations are affine in the coordinates, q̈ = a₀ − W (q − q₀), each eigenvector of W moves independently: as a
cosine, or with constant acceleration; with damping, each eigenvector of coordinates and rates together moves as an
exponential. The tape shows whether the equations are affine. An interval is short enough that no margin can reach
zero in it, whatever the phases of the modes.
"""

from dataclasses import dataclass
from math import pi

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.exact.affine import LinearEquations
from sim2reason.simulation.engines.exact.dop853 import Values
from sim2reason.simulation.engines.exact.eigenpairs import (
    MAX_CONDITION_NUMBER,
    REST_SPEED,
    DampedModes,
    find_damped_modes,
)

IMAGINARY_RTOL = 1e-9  # fraction of the largest eigenvalue: a smaller imaginary part counts as zero
ZERO_EIGENVALUE_RTOL = 1e-13  # fraction of the largest eigenvalue: a smaller eigenvalue counts as zero
SUBDIVISIONS = 8  # subdivisions of the fastest period
MAX_HALVINGS = 30  # largest number of times that an interval is halved
FINE_SUBDIVISIONS = 64  # subdivisions of the fastest period if margins are evaluated on each piece
MAX_PIECES = 2500 * FINE_SUBDIVISIONS  # largest number of pieces in one interval
MAX_POLISHES = 60  # iterations for the time of a turning point
TURN_TIME_RTOL = 4e-16  # relative accuracy of the time of a turning point


@dataclass(frozen=True)
class Modes:
    """Eigenmodes s of a linear motion from one instant on: q − q₀ = `ways` · s, with s̈ = force − square · s."""

    time: float
    place: Array  # q₀, (n,)
    ways: Array  # a column for each mode, (n, n)
    square: Array  # of angular frequencies, 1/s²; 0 for a mode without restoring force
    force: Array
    speed: Array  # ṡ at the start

    @property
    def rate(self) -> Array:
        """Return the angular frequencies of the modes, rad/s."""
        return np.sqrt(self.square)

    @property
    def fastest(self) -> float:
        """Return the largest angular frequency, rad/s."""
        return float(self.rate.max())

    @property
    def start(self) -> Array:
        """Return the coordinates and rates at the start, (2n,)."""
        return np.concatenate([self.place, self.ways @ self.speed])

    def at(self, times: Array) -> Array:
        """Return the coordinates and rates at times (m,), of shape (m, 2n)."""
        since, w = (times - self.time)[:, None], self.rate
        swings = w > 0.0
        divisor = np.where(swings, w, 1.0)
        middle, size = self.force / divisor**2, self.speed / divisor
        cosine, sine, half = np.cos(since * divisor), np.sin(since * divisor), np.sin(0.5 * since * divisor)
        s = np.where(swings, 2.0 * middle * half * half + size * sine, since * (self.speed + 0.5 * since * self.force))
        u = np.where(swings, divisor * (middle * sine + size * cosine), self.speed + since * self.force)
        return np.concatenate([self.place + s @ self.ways.T, u @ self.ways.T], axis=1)

    def least(self, slopes: Array, span: float) -> Array:
        """Return lower bounds (m,), within `span` seconds, of the changes of functions slopes · (q, q̇), (m, 2n)."""
        effects = (slopes @ self._spread)[:, :, None] * self._ranges(span)[None]
        bounds: Array = effects.min(axis=2).sum(axis=1)
        return bounds

    def accelerations(self, times: Array) -> Array:
        """Return the accelerations at times (m,), of shape (m, n)."""
        phase = (times - self.time)[:, None] * self.rate
        acceleration: Array = (self.force * np.cos(phase) - self.speed * self.rate * np.sin(phase)) @ self.ways.T
        return acceleration

    def bend(self, slopes: Array) -> Array:
        """Return upper bounds (m,) of the second time derivatives of the functions slopes · (q, q̇), (m, 2n)."""
        size = np.hypot(self.force, self.speed * self.rate)
        bounds: Array = np.abs(slopes @ self._spread) @ np.concatenate([size, size * self.rate])
        return bounds

    def moves_until(self, span: float) -> float:
        """Return `span`, in s, since an undamped motion never comes to rest."""
        return span

    @property
    def _spread(self) -> Array:
        return np.asarray(np.kron(np.eye(2), self.ways), dtype=np.float64)

    def _ranges(self, span: float) -> Array:
        """Return lower and upper bounds of the changes of s and of its rate within `span` seconds, (2n, 2)."""
        s, u = self.ranges(span)
        return np.concatenate([s, u]) - np.concatenate([np.zeros(len(self.place)), self.speed])[:, None]

    def ranges(self, span: float) -> tuple[Array, Array]:
        """Return lower and upper bounds of s and of ṡ during the first `span` seconds, of shape (n, 2) each."""
        w = self.rate
        swings = w > 0.0
        divisor = np.where(swings, w, 1.0)
        middle = self.force / divisor**2
        size = np.hypot(middle, self.speed / divisor)
        turned = np.clip(-self.speed / np.where(self.force, self.force, 1.0), 0.0, span)  # where it turns back
        drift = np.array([t * (self.speed + 0.5 * t * self.force) for t in (np.zeros_like(turned), turned, span)])
        ends = np.array([self.speed, self.speed + span * self.force])
        s = np.where(swings, [middle - size, middle + size], [drift.min(axis=0), drift.max(axis=0)])
        u = np.where(swings, [-divisor * size, divisor * size], [ends.min(axis=0), ends.max(axis=0)])
        return s.T, u.T


@dataclass(frozen=True)
class LinearInterval:
    """An interval of linear motion that is solved by eigenmodes."""

    modes: Modes | DampedModes
    length: float  # s

    @property
    def time(self) -> float:
        """Return the start time, s."""
        return self.modes.time

    @property
    def knots(self) -> Array:
        """Return the times, s, that divide the interval into equal pieces, each shorter than the fastest period."""
        return self.time + np.arange(1, pieces(self.modes, self.length)) * self.length / pieces(self.modes, self.length)

    @property
    def new(self) -> Values:
        """Return the coordinates and rates at the end of the interval."""
        return tuple(self.modes.at(np.array([self.time + self.length]))[0].tolist())


def pieces(modes: Modes | DampedModes, span: float) -> int:
    """Return the number of equal pieces of a span such that each is a small part of the fastest period."""
    return max(1, int(np.ceil(span * modes.fastest / (2.0 * pi) * SUBDIVISIONS)))


def find_modes(linear: LinearEquations, time: float, values: Values) -> Modes | DampedModes | None:
    """Return the eigenmodes of linear equations from an instant on; None if the eigenvectors do not form a basis."""
    n, here, base = len(linear.base), np.array(values), linear.accelerations(values)
    if linear.damped:
        return find_damped_modes(time, here, linear.slopes, base)
    eigenvalues, vectors = linear.squares
    squares, ways = np.real(eigenvalues), np.real(vectors)
    largest = float(np.abs(eigenvalues).max())
    if (
        not largest
        or np.abs(np.imag(eigenvalues)).max() > IMAGINARY_RTOL * largest
        or squares.min() < -ZERO_EIGENVALUE_RTOL * largest
    ):
        return None
    if np.linalg.cond(ways) > MAX_CONDITION_NUMBER:
        return None
    kept = np.where(squares > ZERO_EIGENVALUE_RTOL * largest, squares, 0.0)
    force, speed = np.linalg.solve(ways, np.array([base, here[n:]]).T).T
    return Modes(time, here[:n], ways, kept, force, speed)


def solve_interval(
    modes: Modes | DampedModes, span: float, left: Array, slopes: Array, shortest: float
) -> LinearInterval | None:
    """Return the longest interval within `span`, s, without an event; None if it would be below `shortest`, s.

    `left` are the values of all margins (m,) at its start, and `slopes` their gradients, (m, 2n).
    """
    within = span
    for _ in range(MAX_HALVINGS):
        if (left + modes.least(slopes, within) > 0.0).all():
            break
        within *= 0.5
    if within < span:
        within = max(within, _certain(modes, span, left, slopes))
    return LinearInterval(modes, within) if within >= shortest else None


def _certain(modes: Modes | DampedModes, span: float, left: Array, slopes: Array) -> float:
    """Return a time, s, until which no event function is zero, from values at ends of pieces and bounds of curvature.

    On a piece of length h, a function f is at least the smaller of its end values minus h²/8 max |f″|.
    """
    h = 2.0 * pi / modes.fastest / FINE_SUBDIVISIONS
    sag = modes.bend(slopes) * h * h / 8.0
    done, count = 0, FINE_SUBDIVISIONS
    while done < MAX_PIECES and done * h < span:
        at: Array = modes.time + h * np.arange(done, done + count + 1, dtype=np.float64)
        values = left + (modes.at(at) - modes.start) @ slopes.T
        spent = (np.minimum(values[:-1], values[1:]) <= sag).any(axis=1)
        if spent.any():
            return min(span, h * (done + int(spent.argmax())))
        done, count = done + count, 2 * count
    return min(span, h * done)


def turning_times(modes: Modes | DampedModes, span: float) -> list[tuple[float, int]]:
    """Return the times at which the speed of a coordinate passes through zero, in order, each with its coordinate."""
    span = modes.moves_until(span)
    n, count = len(modes.start) // 2, pieces(modes, span)
    times = modes.time + np.linspace(0.0, span, count + 1)
    speeds = modes.at(times)[:, n:]
    turns: list[tuple[float, int]] = []
    for number in range(n):
        own = speeds[:, number]
        fast = np.maximum(np.abs(own[:-1]), np.abs(own[1:])) > REST_SPEED
        at = np.flatnonzero((own[:-1] * own[1:] < 0.0) & fast)
        if len(at):
            turns += [(time, number) for time in _turns(modes, number, times[at], times[at + 1]).tolist()]
    return sorted(turns)


def _turns(modes: Modes | DampedModes, number: int, low: Array, high: Array) -> Array:
    """Return the times at which a coordinate's speed is zero, one in each interval, by safeguarded Newton iteration."""
    n = len(modes.start) // 2
    sign, time = np.sign(modes.at(low)[:, n + number]), 0.5 * (low + high)
    for _ in range(MAX_POLISHES):
        speed = modes.at(time)[:, n + number]
        before = sign * speed > 0.0
        low, high = np.where(before, time, low), np.where(before, high, time)
        with np.errstate(divide="ignore", invalid="ignore"):
            step = speed / modes.accelerations(time)[:, number]
        done = np.abs(step) <= TURN_TIME_RTOL * time
        if done.all():
            break
        guess = time - step
        time = np.where(done, time, np.where((low < guess) & (guess < high), guess, 0.5 * (low + high)))
    return time
