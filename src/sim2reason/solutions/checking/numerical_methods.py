"""Numerical methods: collocation for initial-value problems, and Gaussian quadrature of elliptic integrals.

In each step of the collocation the state is a polynomial through Chebyshev points. Its derivative is that of the
equations at all points, found by Picard iteration (C. W. Clenshaw and H. J. Norton, The Computer Journal 6, 1963). The
engines use Runge–Kutta methods instead.
"""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TypeAlias

import numpy as np
import numpy.typing as npt
from numpy.polynomial import chebyshev

LEGENDRE_NODES, LEGENDRE_WEIGHTS = np.polynomial.legendre.leggauss(20)
MAX_BISECTIONS = 40  # bisections of the distance to 90°, where the integrand varies fast for moduli close to 1
NEWTON_ITERATIONS = 60  # of Newton's method
NEWTON_RTOL = 1e-15  # relative
Derived = tuple[float, tuple[float, ...]]
"""A value with its derivatives by the arguments."""


def complete_integral(modulus: float) -> Derived:
    """Return K(k) = ∫ dθ/√(1 − k² sin² θ) from 0 to 90° and its derivative; ValueError unless 0 ≤ k < 1."""
    value, (_, slope) = incomplete_integral(0.5 * math.pi, modulus)
    return value, (slope,)


def incomplete_integral(angle: float, modulus: float) -> Derived:
    """Return F(θ, k), the integral up to an angle in radians, and its derivatives; ValueError unless 0 ≤ k < 1."""
    if not 0.0 <= modulus < 1.0:
        raise ValueError(f"an elliptic integral of the modulus {modulus:g}")
    turns = round(angle / math.pi)
    rest = angle - turns * math.pi
    whole, by_modulus = _quadrature(abs(rest), modulus)
    if turns:
        quarter, slope = _quadrature(0.5 * math.pi, modulus)
        whole, by_modulus = math.copysign(whole, rest) + 2.0 * turns * quarter, math.copysign(by_modulus, rest)
        by_modulus += 2.0 * turns * slope
    else:
        whole, by_modulus = math.copysign(whole, rest), math.copysign(by_modulus, rest)
    return whole, (1.0 / math.sqrt(1.0 - (modulus * math.sin(angle)) ** 2), by_modulus)


def amplitude(integral: float, modulus: float) -> Derived:
    """Return am(u, k), the angle in radians with F(θ, k) = u, by Newton's method; ValueError unless 0 ≤ k < 1."""
    quarter, _ = complete_integral(modulus)
    angle = 0.5 * math.pi * integral / quarter
    for _ in range(NEWTON_ITERATIONS):
        value, (slope, by_modulus) = incomplete_integral(angle, modulus)
        step = (value - integral) / slope
        angle -= step
        if abs(step) <= NEWTON_RTOL * max(1.0, abs(angle)):
            break
    value, (slope, by_modulus) = incomplete_integral(angle, modulus)
    return angle, (1.0 / slope, -by_modulus / slope)


def _quadrature(angle: float, modulus: float) -> tuple[float, float]:
    """Return the integral up to an angle of at most 90°, and its derivative with respect to the modulus."""
    ends = [0.5 * math.pi * (1.0 - 0.5**n) for n in range(MAX_BISECTIONS)]
    places = [end for end in ends if end < angle] + [angle]
    value, slope = 0.0, 0.0
    for begin, end in pairwise(places):
        half = 0.5 * (end - begin)
        square = np.sin(begin + half * (1.0 + LEGENDRE_NODES)) ** 2
        root = np.sqrt(1.0 - modulus**2 * square)
        value += half * float(LEGENDRE_WEIGHTS @ (1.0 / root))
        slope += half * float(LEGENDRE_WEIGHTS @ (modulus * square / root**3))
    return value, slope


ELLIPTIC_FUNCTIONS = {"elliptic K": complete_integral, "elliptic F": incomplete_integral, "amplitude": amplitude}
ELLIPTIC_ARITY = {"elliptic K": 1, "elliptic F": 2, "amplitude": 2}


Array: TypeAlias = npt.NDArray[np.float64]
Slope: TypeAlias = Callable[[Array, Array], Array]

CHEBYSHEV_DEGREE = 16
CHEBYSHEV_NODES: Array = -np.cos(np.pi * np.arange(CHEBYSHEV_DEGREE + 1) / CHEBYSHEV_DEGREE)
COEFFICIENTS: Array = np.asarray(
    np.linalg.inv(chebyshev.chebvander(CHEBYSHEV_NODES, CHEBYSHEV_DEGREE)), dtype=np.float64
)  # Chebyshev coefficients from values at the nodes
INTEGRALS: Array = (
    chebyshev.chebvander(CHEBYSHEV_NODES, CHEBYSHEV_DEGREE + 1)
    @ chebyshev.chebint(np.eye(CHEBYSHEV_DEGREE + 1), lbnd=-1)
    @ COEFFICIENTS
)  # integrals from -1 to each node
STEP_RTOL = 1e-13  # relative: largest final coefficients of the state in a step
CONVERGENCE_RTOL, STALL_RTOL = 2e-15, 1e-12  # relative changes at which an iteration ends: at once; if it stalls
PICARD_ITERATIONS = 40
ERROR_SCALE_RATIO = 1e-3  # error scale: relative to the largest coordinate or rate, or in SI units, whichever is larger
FIRST, MIN_STEP_RATIO = 1e-2, 1e-13  # first step, s; shortest step, relative to the first


@dataclass(frozen=True, slots=True)
class Piece:
    """One integration step: its begin and length, in s, and the states at the nodes, (nodes, n)."""

    begin: float
    length: float
    states: Array

    @property
    def times(self) -> Array:
        """Return the times of the nodes, s, (nodes,)."""
        return self.begin + 0.5 * self.length * (CHEBYSHEV_NODES + 1.0)

    def state(self, time: float) -> Array:
        """Return the state at a time within the step or near it, (n,)."""
        local_time = 2.0 * (time - self.begin) / self.length - 1.0
        return np.asarray(chebyshev.chebval(local_time, COEFFICIENTS @ self.states), dtype=np.float64)


def tail(values: Array) -> Array:
    """Return the size of the last Chebyshev coefficients, (n,), of polynomials given at the nodes, (nodes, n)."""
    return np.abs(COEFFICIENTS[-2:] @ values).sum(axis=0)


def pieces(slope: Slope, begin: float, start: Array, count: int, fits: Callable[[Piece], bool]) -> Iterator[Piece]:
    """Yield the steps of the integration of an initial-value problem, until one gets too short or infinite.

    Args:
        slope: the time derivatives of states, (m, n), at times, (m,).
        begin: the initial time, s.
        start: the initial state, (n,): coordinates, their rates, and integrals.
        count: the number of coordinates.
        fits: returns whether functions of the state are polynomials within a step, too; if not, it is shortened.
    """
    length, time, state = FIRST, begin, start
    while length > MIN_STEP_RATIO * max(FIRST, abs(time)):
        guess = np.tile(state, (CHEBYSHEV_DEGREE + 1, 1))
        piece = _step(slope, Piece(time, length, guess), state, count)
        ratio = np.inf if piece is None else float((tail(piece.states) / _sizes(piece.states, count)).max()) / STEP_RTOL
        if piece is None or not ratio <= 1.0 or not fits(piece):
            length *= 0.25 if not np.isfinite(ratio) else min(0.7, max(0.2, 0.8 * ratio ** (-1.0 / CHEBYSHEV_DEGREE)))
            continue
        yield piece
        time, state = time + length, piece.states[-1]
        length *= min(3.0, 0.9 * max(ratio, 1e-12) ** (-1.0 / CHEBYSHEV_DEGREE))


def state_at(slope: Slope, piece: Piece, time: float, count: int) -> Array:
    """Return the state at a time within a step, (n,), by an integration that ends at that time.

    Rates may have a kink at that time, as the rate of a path length has at zero speed.
    """
    begin, length = piece.state(piece.begin), time - piece.begin
    if length <= MIN_STEP_RATIO * piece.length:
        return begin
    substep = _step(slope, Piece(piece.begin, length, np.tile(begin, (CHEBYSHEV_DEGREE + 1, 1))), begin, count)
    return piece.state(time) if substep is None else substep.states[-1]


def _sizes(states: Array, count: int) -> Array:
    """Return the error scales of coordinates, rates and integrals, (n,)."""
    sizes = np.maximum(np.abs(states).max(axis=0), ERROR_SCALE_RATIO)
    for group in (slice(0, count), slice(count, 2 * count)):
        sizes[group] = np.maximum(sizes[group], ERROR_SCALE_RATIO * sizes[group].max(initial=0.0))
    return sizes


def _step(slope: Slope, piece: Piece, start: Array, count: int) -> Piece | None:
    """Iterate the states of a step until they fulfil the differential equation at all nodes; None if they do not."""
    states, times, last = piece.states, piece.times, np.inf
    for _ in range(PICARD_ITERATIONS):
        try:
            updated = start + 0.5 * piece.length * (INTEGRALS @ slope(times, states))
        except ArithmeticError:
            return None
        if not np.isfinite(updated).all():
            return None
        change = float((np.abs(updated - states).max(axis=0) / _sizes(updated, count)).max())
        states = updated
        if change <= CONVERGENCE_RTOL or (change <= STALL_RTOL and change >= 0.5 * last):
            return Piece(piece.begin, piece.length, states)
        last = change
    return None
