"""Steps of the midpoint rule, extrapolated to steps of zero length (Gragg, Bulirsch, Stoer), and the motion between.

E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I (1993), section II.9. The method differs
from that of the exact engine, so that the engines do not share errors.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import sqrt
from typing import NamedTuple

import numpy as np

from sim2reason.scenes.dsl.state import Array

SUBSTEP_SEQUENCE = (2, 4, 6, 8)  # numbers of substeps
MIN_STAGE = 1  # index of the first of them after which a step may be accepted
SAFETY, MIN_STEP_RATIO, MAX_STEP_RATIO = 0.85, 0.1, 2.0  # safety factor, smallest and largest ratio of successive steps

STEP_SIMILARITY = 0.1  # fraction of a step: neighbours of a more different size are left out of the interpolation

Rate = Callable[[float, Array], Array]
"""A function that returns the time derivative of the values at a time as a new array, which its caller may change."""

_WEIGHTS = [
    [(substeps / SUBSTEP_SEQUENCE[column - order - 1]) ** 2 - 1.0 for order in range(column)]
    for column, substeps in enumerate(SUBSTEP_SEQUENCE)
]  # by which the extrapolations to zero step size divide


class Extrapolated(NamedTuple):
    """The values at the end of a step, its error relative to the tolerance, and the ratio for the next step size."""

    values: Array
    error: float
    factor: float


def extrapolate_step(rate: Rate, time: float, values: Array, first: Array, h: float, tolerance: float) -> Extrapolated:
    """Compute a step of size `h` from `values`, where the rate is `first`, with the order required by the tolerance."""
    table: list[Array] = []
    error, sizes = 0.0, abs(values)
    for column, substeps in enumerate(SUBSTEP_SEQUENCE):
        row = [_midpoint(rate, time, values, first, h, substeps)]
        for order, weight in enumerate(_WEIGHTS[column]):
            row.append(_extrapolate(row[order], table[order], weight))
        table = row
        if column >= MIN_STAGE:
            error = _error(row, sizes, tolerance)
            if error <= 1.0:
                break
    spare = len(SUBSTEP_SEQUENCE) - len(table)
    return Extrapolated(table[-1], error, MAX_STEP_RATIO if spare else _factor(error))


def _extrapolate(finer: Array, coarser: Array, weight: float) -> Array:
    """Return the value at zero step size of a line through two results."""
    found: Array = finer - coarser
    found /= weight
    found += finer
    return found


def _error(row: list[Array], sizes: Array, tolerance: float) -> float:
    """Return the root mean square of the last difference, relative to the tolerance for values of such `sizes`."""
    if not len(sizes):
        return 0.0
    scale: Array = np.maximum(sizes, abs(row[-1]))
    scale += 1e-2
    scale *= tolerance
    difference: Array = row[-1] - row[-2]
    difference /= scale
    difference *= difference
    return sqrt(float(np.add.reduce(difference)) / len(sizes))  # `np.mean` takes longer than all of these lines


def _midpoint(rate: Rate, time: float, values: Array, first: Array, h: float, substeps: int) -> Array:
    """Return the result of the midpoint rule; even `substeps` do not need Gragg's final smoothing."""
    step = h / substeps
    double = 2.0 * step
    before, here = values, values + step * first
    for number in range(1, substeps):
        following = rate(time + number * step, here)
        following *= double
        following += before
        before, here = here, following
    return here


def _factor(error: float) -> float:
    return (
        min(MAX_STEP_RATIO, max(MIN_STEP_RATIO, SAFETY * error ** (-1.0 / (2 * len(SUBSTEP_SEQUENCE) - 1))))
        if error
        else MAX_STEP_RATIO
    )


# ---- between the ends of steps


@dataclass(frozen=True)
class Knot:
    """The end of a step: joint positions and velocities, and their time derivatives."""

    time: float
    values: Array  # (2·joints,)
    rates: Array


class Quintic:
    """The quintic Hermite interpolation of a step, from values, first and second derivatives at both ends."""

    def __init__(self, first: Knot, last: Knot) -> None:
        """Compute the coefficients of the interpolation."""
        n = len(first.values) // 2
        self._time, self._span, self._start = first.time, last.time - first.time, first.values
        ends = (first.values[:n], first.values[n:], first.rates[n:], last.values[:n], last.values[n:], last.rates[n:])
        self._joints = [_coefficients(self._span, *at) for at in zip(*(end.tolist() for end in ends), strict=True)]

    def at(self, time: float) -> tuple[Array, Array]:
        """Return positions and velocities at a time of the step, (joints,) each."""
        if self._span <= 0.0:
            n = len(self._start) // 2
            return self._start[:n], self._start[n:]
        x = (time - self._time) / self._span
        q = [q0 + x * (v0 + x * (c + x * (d + x * (e + x * f)))) for q0, v0, c, d, e, f in self._joints]
        v = [
            (v0 + x * (2.0 * c + x * (3.0 * d + x * (4.0 * e + 5.0 * x * f)))) / self._span
            for _, v0, c, d, e, f in self._joints
        ]
        return np.array(q), np.array(v)


def _coefficients(
    h: float, q0: float, v0: float, a0: float, q1: float, v1: float, a1: float
) -> tuple[float, float, float, float, float, float]:
    """Return the polynomial of the fraction of a step of length `h`, from position, velocity and acceleration."""
    v0, a0, v1, a1 = v0 * h, a0 * h * h, v1 * h, a1 * h * h
    rise = q1 - q0
    return (
        q0,
        v0,
        0.5 * a0,
        10.0 * rise - 6.0 * v0 - 4.0 * v1 - 1.5 * a0 + 0.5 * a1,
        -15.0 * rise + 8.0 * v0 + 7.0 * v1 + 1.5 * a0 - a1,
        6.0 * rise - 3.0 * (v0 + v1) - 0.5 * (a0 - a1),
    )


def interpolate_knots(knots: Sequence[Knot], times: Array) -> Array:
    """Return positions and velocities at times, (m, 2·joints), by Hermite interpolation between ends of steps."""
    n, origin = len(knots[0].values) // 2, knots[0].time
    h = knots[-1].time - origin
    if h <= 0.0:
        return np.repeat(knots[0].values[None, :], len(times), axis=0)
    count, size = len(knots), len(times)
    x = np.concatenate([[knot.time for knot in knots], times])
    x -= origin
    x /= h
    places, slopes, bends = _powers(x, 3 * count)
    matrix = np.concatenate([places[:count], slopes[:count], bends[:count]])
    sides = np.empty((3 * count, n))
    for place, knot in enumerate(knots):
        sides[place], sides[count + place], sides[2 * count + place] = knot.values[:n], knot.values[n:], knot.rates[n:]
    sides[count:] *= h
    sides[2 * count :] *= h
    shape = np.linalg.solve(matrix, sides)
    found: Array = np.empty((size, 2 * n))
    found[:, :n], found[:, n:] = places[count:] @ shape, slopes[count:] @ shape
    found[:, n:] /= h
    return found


def neighbouring_knots(knots: Sequence[Knot], place: int) -> Sequence[Knot]:
    """Return the recorded ends of a step, and those of neighbouring steps if these are of similar size."""
    first, last = place, min(place + 1, len(knots) - 1)
    span = knots[last].time - knots[first].time
    for _ in range(2):
        before = first > 0 and _is_similar(knots[first].time - knots[first - 1].time, span)
        after = last + 1 < len(knots) and _is_similar(knots[last + 1].time - knots[last].time, span)
        if before and (first == place or not after):
            first -= 1
        elif after:
            last += 1
    return knots[first : last + 1]


def _is_similar(step: float, span: float) -> bool:
    return STEP_SIMILARITY * span < step < span / STEP_SIMILARITY


def _powers(x: Array, count: int) -> tuple[Array, Array, Array]:
    """Return the first powers of numbers, with their first and second derivatives, (numbers, count) each."""
    powers: Array = np.arange(float(count))
    place: Array = x[:, None] ** powers
    rate, bend = np.zeros_like(place), np.zeros_like(place)
    np.multiply(powers[1:], place[:, :-1], out=rate[:, 1:])
    np.multiply((powers * (powers - 1.0))[2:], place[:, :-2], out=bend[:, 2:])
    return place, rate, bend
