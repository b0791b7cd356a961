"""Long stretches of linear motion solved at once by eigenmodes, where an integrator would need too many steps.

Where accelerations are affine in the coordinates, q̈ = a₀ − W (q − q₀), each eigenvector of W moves independently: as a
cosine, or with a constant acceleration; with damping, each eigenvector of coordinates and rates together does, as an
exponential. Whether they are affine is tested at corners of the box that contains the whole stretch. A stretch is short
enough that no margin can be used up on it, whatever the phases of the modes.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import islice, product
from math import pi

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.simulation.engines.exact.damped_modes import DampedModes, found_damped
from sim2reason.simulation.engines.exact.dop853 import Rate, Values

Margins = Callable[[float, Values], Sequence[float]]

EXACT = 1e-9  # of the largest acceleration, or margin: by how much what is affine may be off
STILL = 1e-9  # of the largest eigenvalue: less is none
SOUND = 1e8  # condition of the eigenvectors, at most
LARGER = 7  # powers of ten by which changes are tried that are larger
CORNERS = 16  # of the box, at which is tried
SHARE = 8  # pieces of the fastest period
SHORTEST = 10  # fastest periods, fewer of which are no stretch
HALVINGS = 30
POLISHES = 60  # bisections of the time of a turn


@dataclass(frozen=True)
class Modes:
    """Eigenmodes s of a linear motion from one instant on: q − q₀ = `ways` · s, with s̈ = force − square · s."""

    time: float
    place: Array  # q₀, (n,)
    ways: Array  # a column for each mode, (n, n)
    square: Array  # of angular frequencies, 1/s²; 0 of a mode without
    force: Array
    speed: Array  # ṡ at the beginning

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
        """Return the coordinates and rates at the beginning, (2n,)."""
        return np.concatenate([self.place, self.ways @ self.speed])

    def at(self, times: Array) -> Array:
        """Return the coordinates and rates at times (m,), of shape (m, 2n)."""
        since, w = (times - self.time)[:, None], self.rate
        swings = w > 0.0
        divisor = np.where(swings, w, 1.0)
        middle, size = self.force / divisor**2, self.speed / divisor
        cosine, sine = np.cos(since * divisor), np.sin(since * divisor)
        s = np.where(swings, middle * (1.0 - cosine) + size * sine, since * (self.speed + 0.5 * since * self.force))
        u = np.where(swings, divisor * (middle * sine + size * cosine), self.speed + since * self.force)
        return np.concatenate([self.place + s @ self.ways.T, u @ self.ways.T], axis=1)

    def least(self, slopes: Array, span: float) -> Array:
        """Return a bound below the changes in `span`, s, of functions with these slopes (m, 2n), of shape (m,)."""
        effects = (slopes @ self._spread)[:, :, None] * self._ranges(span)[None]
        found: Array = effects.min(axis=2).sum(axis=1)
        return found

    def changes(self, span: float) -> list[Array]:
        """Return changes of coordinates and rates, (2n,) each, of the size of those during the first `span`, s."""
        ranges = self._ranges(span)
        found: list[Array] = [self._spread @ np.array(corner) for corner in islice(product(*ranges), CORNERS)]
        return found + [self._spread @ ranges[:, side] for side in (0, 1)]

    def accelerations(self, change: Array) -> Array:
        """Return the accelerations after a change of coordinates and rates, (n,)."""
        n = len(self.place)
        found: Array = self.ways @ (self.force - self.square * (np.linalg.inv(self.ways) @ change[:n]))
        return found

    def load(self, change: Array) -> float:
        """Return the largest acceleration after a change of coordinates and rates."""
        return float(np.abs(self.accelerations(change)).max())

    def moves_until(self, span: float) -> float:
        """Return for how much of `span`, s, it moves: all of it."""
        return span

    @property
    def _spread(self) -> Array:
        return np.asarray(np.kron(np.eye(2), self.ways), dtype=np.float64)

    def _ranges(self, span: float) -> Array:
        """Return the bounds of the changes of s and of its rate, (2n, 2)."""
        s, u = self.ranges(span)
        return np.concatenate([s, u]) - np.concatenate([np.zeros(len(self.place)), self.speed])[:, None]

    def ranges(self, span: float) -> tuple[Array, Array]:
        """Return the bounds of s and of ṡ during the first `span`, s, of shape (n, 2) each."""
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
class Stretch:
    """A stretch of linear motion."""

    modes: Modes | DampedModes
    length: float  # s

    @property
    def time(self) -> float:
        """Return the time at which the stretch begins, s."""
        return self.modes.time

    @property
    def knots(self) -> Array:
        """Return the times between which the motion is smooth and simple, s."""
        return self.time + np.arange(1, pieces(self.modes, self.length)) * self.length / pieces(self.modes, self.length)

    @property
    def new(self) -> Values:
        """Return the coordinates and rates at the end of the stretch."""
        return tuple(self.modes.at(np.array([self.time + self.length]))[0].tolist())


def pieces(modes: Modes | DampedModes, span: float) -> int:
    """Return the number of pieces into which to divide a span so that the fastest mode is simple on each piece."""
    return max(1, int(np.ceil(span * modes.fastest / (2.0 * pi) * SHARE)))


def found_modes(rate: Rate, time: float, values: Values, sizes: Array) -> Modes | DampedModes | None:
    """Return the eigenmodes at an instant, or None; `sizes` (2n,) are the changes for differences."""
    n = len(values) // 2
    here = np.array(values)
    base = np.array(rate(time, values))[n:]
    slopes = _affine_slopes(lambda at: rate(time, at)[n:], here, sizes)
    load = float(np.abs(slopes * sizes).max(initial=0.0))
    if not load:
        return None
    if np.abs(slopes[:, n:] * sizes[n:]).max() > EXACT * load:
        return found_damped(time, here, slopes, base)
    eigenvalues, vectors = np.linalg.eig(-slopes[:, :n])
    largest, turned = float(np.abs(eigenvalues).max()), float(np.abs(np.imag(eigenvalues)).max())
    squares: Array = np.asarray(np.real(eigenvalues), dtype=np.float64)
    ways: Array = np.asarray(np.real(vectors), dtype=np.float64)
    if turned > STILL * largest or squares.min() < -STILL * largest or np.linalg.cond(ways) > SOUND:
        return None
    inverse: Array = np.asarray(np.linalg.inv(ways), dtype=np.float64)
    kept = np.where(squares > STILL * largest, squares, 0.0)
    return Modes(time, here[:n], ways, kept, inverse @ base, inverse @ here[n:])


def _slopes(code: Callable[[Values], Sequence[float]], here: Array, sizes: Array) -> Array:
    """Return the derivatives of numbers with respect to values by central differences, of shape (numbers, values)."""
    columns: list[Array] = []
    for number, size in enumerate(sizes):
        change = np.zeros(len(here))
        change[number] = size
        columns.append(_difference(code, here, change))
    return np.array(columns).T


def _difference(code: Callable[[Values], Sequence[float]], here: Array, change: Array) -> Array:
    after, before = (np.array(code(tuple((here + sign * change).tolist()))) for sign in (1.0, -1.0))
    found: Array = (after - before) / (2.0 * np.abs(change).max())
    return found


def _affine_slopes(code: Callable[[Values], Sequence[float]], here: Array, sizes: Array) -> Array:
    """Return derivatives as `_slopes` does, of numbers that are affine, each by the change that rounding blurs least.

    Over a change ten times as large the rounding errors of an affine number are a tenth. So the derivative changes ever
    less from one size to the next, until rounding is none of its errors, or the number is not affine any farther.
    """
    found = _slopes(code, here, sizes)
    for number, size in enumerate(sizes):
        change = np.zeros(len(here))
        known, differs = found[:, number], np.inf
        for power in range(1, LARGER):
            change[number] = 10.0**power * size
            try:
                wider = _difference(code, here, change)
            except (ZeroDivisionError, OverflowError, ValueError):
                break
            before, differs = differs, float(np.abs(wider - known).max())
            if not differs < before or differs > EXACT * float(np.abs(known).max()):
                break
            found[:, number] = known = wider
    return found


def stretch(modes: Modes | DampedModes, span: float, rate: Rate, margins: Margins, sizes: Array) -> Stretch | None:
    """Return a linear stretch of at most `span`, s, on which no event can be due; None if no stretch is worthwhile."""
    shortest = SHORTEST * 2.0 * pi / modes.fastest
    values: Values = tuple(modes.start.tolist())
    left = np.array(margins(modes.time, values))
    slopes = _slopes(lambda at: margins(modes.time, at), modes.start, sizes) if len(left) else np.zeros((0, len(sizes)))
    for _ in range(HALVINGS):
        if span < shortest:
            return None
        if (left + modes.least(slopes, span) > 0.0).all():
            is_affine = _is_affine(modes, (rate, margins), (left, slopes), span)
            return Stretch(modes, span) if is_affine else None
        span *= 0.5
    return None


def _is_affine(modes: Modes | DampedModes, code: tuple[Rate, Margins], known: tuple[Array, Array], span: float) -> bool:
    """Return whether rates and margins agree with the eigenmodes at far corners, at both ends of a stretch."""
    n = len(modes.start) // 2
    for change in modes.changes(span):
        values: Values = tuple((modes.start + change).tolist())
        wanted = modes.accelerations(change)
        for time in (modes.time, modes.time + span):
            found, left = np.array(code[0](time, values))[n:], np.array(code[1](time, values))
            if np.abs(found - wanted).max() > EXACT * modes.load(change):
                return False
            expected = known[0] + known[1] @ change
            if len(left) and (np.abs(left - expected) > EXACT * np.abs(known[1] * change).sum(axis=1) + EXACT).any():
                return False
    return True


def turns(modes: Modes | DampedModes, span: float) -> list[tuple[float, int]]:
    """Return the times when the speed of a coordinate passes through zero, in order, each with its coordinate."""
    span = modes.moves_until(span)
    n, count = len(modes.start) // 2, pieces(modes, span)
    times = modes.time + np.linspace(0.0, span, count + 1)
    speeds = modes.at(times)[:, n:]
    found: list[tuple[float, int]] = []
    for number in range(n):
        own = speeds[:, number]
        at = np.flatnonzero(own[:-1] * own[1:] < 0.0)
        low, high, sign = times[at], times[at + 1], np.sign(own[at])
        for _ in range(POLISHES if len(at) else 0):
            middle = 0.5 * (low + high)
            before = sign * modes.at(middle)[:, n + number] > 0.0
            low, high = np.where(before, middle, low), np.where(before, high, middle)
        found += [(time, number) for time in low.tolist()]
    return sorted(found)
