"""The midpoint rule, extrapolated to steps of zero length (Gragg, Bulirsch, Stoer).

E. Hairer, S. P. Nørsett, G. Wanner, Solving Ordinary Differential Equations I (1993), section II.9. The method differs
from that of the exact engine, so that the engines do not share errors.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from sim2reason.scenes.dsl.state import Array

SEQUENCE = (2, 4, 6, 8)  # numbers of substeps
MIN_STAGE = 1  # index of the first of them after which a step may be accepted
SAFETY, MIN_STEP_RATIO, MAX_STEP_RATIO = 0.85, 0.1, 2.0  # safety factor, smallest and largest ratio of successive steps

Rate = Callable[[float, Array], Array]


class Extrapolated(NamedTuple):
    """The values at the end of a step, its error relative to the tolerance, and the ratio for the next step size."""

    values: Array
    error: float
    factor: float


def extrapolate_step(rate: Rate, time: float, values: Array, first: Array, h: float, tolerance: float) -> Extrapolated:
    """Compute a step of size `h` from `values`, where the rate is `first`, with the order required by the tolerance."""
    table: list[Array] = []
    error = 0.0
    for column, substeps in enumerate(SEQUENCE):
        row = [_midpoint(rate, time, values, first, h, substeps)]
        for order in range(column):
            weight = (substeps / SEQUENCE[column - order - 1]) ** 2 - 1.0
            row.append(row[order] + (row[order] - table[order]) / weight)
        table = row
        if column >= MIN_STAGE:
            scale = tolerance * (1e-2 + np.maximum(np.abs(values), np.abs(row[-1])))
            apart = (row[-1] - row[-2]) / scale
            error = float(np.sqrt(np.mean(apart * apart))) if len(values) else 0.0
            if error <= 1.0:
                break
    spare = len(SEQUENCE) - len(table)
    return Extrapolated(table[-1], error, MAX_STEP_RATIO if spare else _factor(error))


def _midpoint(rate: Rate, time: float, values: Array, first: Array, h: float, substeps: int) -> Array:
    """Return the result of the midpoint rule; even `substeps` do not need Gragg's final smoothing."""
    step = h / substeps
    before, here = values, values + step * first
    for number in range(1, substeps):
        before, here = here, before + 2.0 * step * rate(time + number * step, here)
    return here


def _factor(error: float) -> float:
    return (
        min(MAX_STEP_RATIO, max(MIN_STEP_RATIO, SAFETY * error ** (-1.0 / (2 * len(SEQUENCE) - 1))))
        if error
        else MAX_STEP_RATIO
    )
