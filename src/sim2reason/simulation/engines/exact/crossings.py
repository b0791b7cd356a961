"""Integrator steps with dense output, and the roots of event functions within them."""

from collections.abc import Callable, Sequence
from itertools import pairwise
from math import sqrt
from typing import NamedTuple

import numpy as np

from sim2reason.simulation.engines.exact import dop853
from sim2reason.simulation.engines.exact.dop853 import Rate, Values
from sim2reason.simulation.engines.exact.margins import Formulas

ARMING_MARGIN = (
    1e-9  # value that an event function must exceed after starting at zero before its return to zero is an event
)
MARGIN_DRIFT = 1e-7  # a margin may start this far below zero, as integration and impacts leave it
MAX_TANGENTS = 12  # pairs of tangents used to locate a minimum
EDGE_FRACTION = 0.05  # fraction of an interval: fraction near its ends where an intersection of tangents is ignored
SLOPE_STEP = 1e-6  # fraction of a step: width of the finite difference for a slope
MAX_HALVINGS = 12  # bisections towards the start in search of a margin that rises from zero

Margin = Callable[[float], float]
"""An event function, which is zero at the event, over the fraction of the step."""
Sample = tuple[float, float]


class Crossing(NamedTuple):
    """The part of a step in which an event function plus `room` changes from positive to nonpositive."""

    low: float
    high: float
    room: float = 0.0


class MarginWatch:
    """The state of a mode's event functions: which were ever positive, and how far the others may be negative."""

    def __init__(self, start: Sequence[float]) -> None:
        """Store the event functions at the start of a mode; one that starts at zero must first become positive."""
        self._armed = [margin > ARMING_MARGIN for margin in start]
        self._room = [
            ARMING_MARGIN - margin if -MARGIN_DRIFT < margin < 0.0 else ARMING_MARGIN if margin >= 0.0 else 0.0
            for margin in start
        ]

    def passed(self, after: Sequence[float]) -> None:
        """Record which event functions are positive at the end of a step without an event."""
        self._armed = [was or margin > ARMING_MARGIN for was, margin in zip(self._armed, after, strict=True)]

    def crossings(
        self, ends: Sequence[Sequence[float]], margins: Callable[[float], Sequence[float]]
    ) -> list[tuple[int, Crossing]]:
        """Return index and first zero of each event function with a zero; `ends`: values at 0, ½ and 1 of the step."""
        known: dict[float, Sequence[float]] = {}

        def at(x: float) -> Sequence[float]:
            if x not in known:
                known[x] = margins(x)
            return known[x]

        zeros: list[tuple[int, Crossing]] = []
        for number, values in enumerate(zip(*ends, strict=True)):
            first, middle, last = values
            if min(values) <= abs(first - middle) + abs(middle - last):  # else it is more than all by which it changes
                crossing = self._first(number, values, lambda x, i=number: at(x)[i])
                if crossing is not None:
                    zeros.append((number, crossing))
        return zeros

    def _first(self, number: int, values: tuple[float, float, float], margin: Margin) -> Crossing | None:
        samples: list[Sample] = list(zip((0.0, 0.5, 1.0), values, strict=True))
        armed, room = self._armed[number], self._room[number]
        if min(values) >= 0.0:
            samples = sorted([*samples, *_dips(margin, samples)])
        elif not armed:
            samples = sorted([*samples, *_rise(margin, samples)])
        last = 0.0
        for x, value in samples:
            if armed and value < 0.0:
                return Crossing(last, x)
            if not armed and value < -room:
                return Crossing(last, x, room)
            armed, last = armed or value > ARMING_MARGIN, x
        return None


def _dips(margin: Margin, samples: Sequence[Sample]) -> list[Sample]:
    """Return points at which an event function, positive at all samples, is negative between them.

    A minimum lies between two samples if the margin falls at the first and rises at the second. The tangents there
    bound the minimum from below if the margin is convex: an intersection above zero excludes an event.
    """
    dips: list[Sample] = []
    for one, other in pairwise(samples):
        dip = _dip(margin, one, other)
        if dip is not None:
            dips.append(dip)
    return dips


def _dip(margin: Margin, one: Sample, other: Sample) -> Sample | None:
    (low, left), (high, right) = one, other
    falls, rises = _slope(margin, low, left, SLOPE_STEP), _slope(margin, high, right, -SLOPE_STEP)
    for _ in range(MAX_TANGENTS):
        if not falls < 0.0 < rises:
            return None
        meet = (left - right + rises * high - falls * low) / (rises - falls)
        if left + falls * (meet - low) > 0.0 or not low < meet < high:
            return None
        width = EDGE_FRACTION * (high - low)
        meet = min(max(meet, low + width), high - width)
        value = margin(meet)
        if value < 0.0:
            return meet, value
        slope = _slope(margin, meet, value, SLOPE_STEP)
        if slope < 0.0:
            low, left, falls = meet, value, slope
        else:
            high, right, rises = meet, value, slope
    return None


def _slope(margin: Margin, x: float, value: float, step: float) -> float:
    return (margin(x + step) - value) / step


def _rise(margin: Margin, samples: Sequence[Sample]) -> list[Sample]:
    """Return a sample, if any, where an event function that starts at zero is positive before it is negative."""
    x = next(x for x, value in samples if value < 0.0)
    for _ in range(MAX_HALVINGS):
        x *= 0.5
        value = margin(x)
        if value > ARMING_MARGIN:
            return [(x, value)]
    return []


class FlowStep:
    """One integrator step with dense output."""

    __slots__ = ("_polynomial", "formulas", "length", "new", "stages", "time", "values")

    def __init__(
        self, formulas: Formulas, time: float, length: float, values: dop853.Values, to: dop853.Advance
    ) -> None:
        """Store the step that starts with `values` (coordinates, then rates) and ends with `to`."""
        self.formulas, self.time, self.length, self.values = formulas, time, length, values
        self.new, self.stages = to.values, to.stages
        self._polynomial: tuple[dop853.Values, ...] | None = None

    @property
    def polynomial(self) -> tuple[dop853.Values, ...]:
        """Return the coefficients of the interpolating polynomial for each unknown."""
        if self._polynomial is None:
            rate = self.formulas.rate
            self._polynomial = dop853.dense(rate, self.time, self.values, self.length, self.new, self.stages)
        return self._polynomial

    def at(self, x: float) -> dop853.Values:
        """Return coordinates and rates (2n,) at a fraction of the step."""
        return dop853.interpolated(self.values, self.polynomial, x)

    def margins(self, x: float) -> tuple[float, ...]:
        """Return all event functions at a fraction of the step."""
        return self.formulas.margins(self.time + x * self.length, self.at(x))

    def closing(self, x: float) -> tuple[float, ...]:
        """Return Δr·Δv, then the distances, of line ends that may pass each other, at a fraction of the step."""
        return self.formulas.closing(self.time + x * self.length, self.at(x))


class StepTable:
    """All steps of an integrated motion in arrays, with the polynomials of the steps evaluated so far."""

    def __init__(self, steps: Sequence[FlowStep]) -> None:
        """Store the steps of a completed integration."""
        self.starts = np.array([step.time for step in steps])
        self.lengths = np.array([step.length for step in steps])
        self.values = np.array([step.values for step in steps])
        self.polynomials = np.empty((dop853.COEFFICIENT_COUNT, *self.values.shape))
        self._filled = set[int]()

    def fill(self, steps: Sequence[FlowStep], numbers: set[int]) -> None:
        """Compute the polynomials of the steps with the given indices."""
        new = sorted(numbers - self._filled)
        if new:
            self._filled.update(new)
            self.polynomials[:, new] = np.array([steps[number].polynomial for number in new]).transpose(2, 0, 1)


UNIT_SIZE_DISPLACEMENT = 1e-3  # m or rad: a larger displacement counts as size 1
REST_DISPLACEMENT = 1e-12  # m or rad: a smaller displacement is round-off of a body at rest
DIFFERENCE_STEP = 1e-8  # m or rad: step of finite differences


def motion_scale(rate: Rate, time: float, values: Values, first: Values) -> float:
    """Return the amplitude of a small motion, m or rad, estimated from one instant; 1 if the motion is not small.

    If forces depend on position, the motion has a time scale τ = 1/√|∂a/∂q|. In this time, speed and acceleration cause
    displacements v τ and a τ². For a circular orbit the result is the radius, for an oscillation the amplitude.
    """
    n = len(values) // 2
    stiffest = 0.0
    for number in range(n):
        moved = list(values)
        moved[number] += DIFFERENCE_STEP
        there = rate(time, tuple(moved))
        stiffest = max(
            stiffest, *(abs(after - now) / DIFFERENCE_STEP for after, now in zip(there[n:], first[n:], strict=True))
        )
    if not stiffest > 0.0:
        return 1.0
    speed, acceleration = (max(map(abs, part), default=0.0) for part in (values[n:], first[n:]))
    size = max(speed / sqrt(stiffest), acceleration / stiffest)
    return size if REST_DISPLACEMENT < size < UNIT_SIZE_DISPLACEMENT else 1.0


MAX_ROOT_ITERATIONS = 200  # largest number of iterations
BISECTION_PATIENCE = 4  # iterations in which the interval should at least be halved
EPSILON = 2.3e-16  # relative resolution of a float


def bracketed_root(function: Callable[[float], float], low: float, high: float) -> float:
    """Return a root between `low`, where the function is positive, and `high`, where it is not.

    Regula falsi, in the form that halves the value of an end that stays (Illinois): M. Dowell, P. Jarratt, A modified
    regula falsi method for computing the root of an equation (1971); and by bisection where that is slow.
    """
    if low == high:
        return low
    above, below = function(low), function(high)
    if above <= 0.0:
        return low
    side, width = 0, high - low
    for number in range(MAX_ROOT_ITERATIONS):
        middle = (low * below - high * above) / (below - above)
        slow = (
            number % BISECTION_PATIENCE == BISECTION_PATIENCE - 1 and high - low > 0.5 * width
        )  # one end never moves at a flat root
        if slow or not low < middle < high:
            middle = 0.5 * (low + high)
        if number % BISECTION_PATIENCE == BISECTION_PATIENCE - 1:
            width = high - low
        value = function(middle)
        if value > 0.0:
            low, above = middle, value
            below = 0.5 * below if side == 1 else below
            side = 1
        else:
            high, below = middle, value
            above = 0.5 * above if side == -1 else above
            side = -1
        if value == 0.0 or high - low <= 4.0 * EPSILON * max(abs(low), abs(high)):
            break
    return high
