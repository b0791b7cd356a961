"""When something happens next, in closed form, where every length is a quadratic of time."""

from dataclasses import dataclass
from math import hypot, inf, sqrt

import numpy as np

from sim2reason.dsl.vectors import Vector, inner
from sim2reason.simulation.engines.exact.linear import Row
from sim2reason.simulation.engines.exact.system import TOUCHING

STILL = 1e-9  # m/s, rad/s or m/s²; what is slower rests
ROUNDING = 1e-12


def crossing(c: float, b: float, a: float) -> float:
    """The first time at which the margin c + bτ + aτ²/2 is used up, or infinity.

    A margin within `TOUCHING` of zero counts as zero: then it is used up at once if it shrinks, else when it
    comes back. Roots are taken in the form that does not cancel.
    """
    if c <= TOUCHING:
        if b < -STILL or (b <= STILL and a < -STILL):
            return 0.0
        return -2.0 * b / a if b > STILL and a < -ROUNDING else inf
    square = b * b - 2.0 * a * c
    if square < 0.0 or (b >= 0.0 and a >= 0.0):
        return inf
    return 2.0 * c / (sqrt(square) - b) if b < 0.0 else (b + sqrt(square)) / -a


def halt(speed: float, acceleration: float) -> float:
    """When a speed passes through zero, or infinity; a coordinate at rest does not stop."""
    return -speed / acceleration if speed * acceleration < 0.0 else inf


@dataclass(slots=True)
class Approach:
    """How two bodies move relative to each other at an instant: separation, velocity, acceleration."""

    apart: Vector
    velocity: Vector
    acceleration: Vector
    distance: float  # at which they touch

    @property
    def gap(self) -> float:
        """The distance left, m."""
        return hypot(*self.apart) - self.distance

    @property
    def rate(self) -> float:
        """The rate of change of the gap, m/s."""
        return inner(self.apart, self.velocity) / hypot(*self.apart)

    @property
    def second(self) -> float:
        """The second derivative of the gap: r̈ = (D·G + W² − ṙ²)/r, m/s²."""
        return (inner(self.apart, self.acceleration) + self.bend) / hypot(*self.apart)

    @property
    def bend(self) -> float:
        """The square of the speed across the line of centres, m²/s²."""
        return inner(self.velocity, self.velocity) - self.rate**2

    @property
    def touching(self) -> bool:
        """Whether the gap is closed."""
        return self.gap <= TOUCHING

    def hit(self) -> float:
        """The time at which the gap closes next, or infinity."""
        resting = self.touching and abs(self.rate) <= STILL
        if self._straight():
            r = hypot(*self.apart)
            pull = inner(self.apart, self.acceleration) / r
            return inf if resting else crossing(self.gap, self.rate, pull)
        if self.touching and self.rate < -STILL:
            return 0.0
        return _first_root(self._polynomial(), 2 if resting else int(self.touching))

    def _straight(self) -> bool:
        r = hypot(*self.apart)
        return all(
            inner(w, w) - (inner(self.apart, w) / r) ** 2 <= ROUNDING**2 * (1.0 + inner(w, w))
            for w in (self.velocity, self.acceleration)
        )

    def _polynomial(self) -> Row:
        """|D + Wτ + Gτ²/2|² − distance², lowest power first."""
        d, w, g = self.apart, self.velocity, self.acceleration
        square = self.gap * (hypot(*d) + self.distance)
        return [square, 2.0 * inner(d, w), inner(w, w) + inner(d, g), inner(w, g), 0.25 * inner(g, g)]


def _first_root(coefficients: Row, touching: int) -> float:
    """The first positive time at which a polynomial, positive till then, reaches zero.

    `touching` is how many roots lie at time zero: they are divided out.
    """
    left = coefficients[touching:]
    while len(left) > 1 and abs(left[-1]) <= ROUNDING**2:
        left = left[:-1]
    if len(left) <= 3:
        c, b, a = (*left, 0.0, 0.0)[:3]
        return _quadratic(c, b, a)
    roots = np.roots(left[::-1])
    real = [float(root.real) for root in roots if abs(root.imag) <= 1e-7 * abs(root) and root.real > 0.0]
    return min((_polished(left, root) for root in real), default=inf)


def _quadratic(c: float, b: float, a: float) -> float:
    """The first positive root of c + bτ + aτ², which begins positive."""
    square = b * b - 4.0 * a * c
    if square < 0.0 or (b >= 0.0 and a >= 0.0):
        return inf
    return 2.0 * c / (sqrt(square) - b) if b < 0.0 else (b + sqrt(square)) / (-2.0 * a)


def _polished(coefficients: Row, root: float) -> float:
    """Newton's steps: eigenvalues of a companion matrix lose a few digits."""
    for _ in range(3):
        value = slope = 0.0
        for coefficient in reversed(coefficients):
            slope = slope * root + value
            value = value * root + coefficient
        if slope == 0.0:
            break
        root -= value / slope
    return root
