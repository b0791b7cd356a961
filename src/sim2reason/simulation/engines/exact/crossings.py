"""Where within a step a margin is used up: also where it only dips, or first rises from nothing."""

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import NamedTuple

ARMED = 1e-9  # what a margin that begins at zero must exceed before it can be due
DRIFT = 1e-7  # how far below zero a margin may begin, as integration and impacts leave it
TANGENTS = 12  # pairs of tangents by which the bottom of a dip is sought
EDGE = 0.05  # of an interval, near its ends, where no tangents need to meet
NEAR = 1e-6  # of a step, over which a slope is taken
HALVES = 12  # times that half of the way back to the start is looked at for a rise from nothing

Margin = Callable[[float], float]
"""A margin at a fraction of the step."""
Sample = tuple[float, float]


class Crossing(NamedTuple):
    """An interval of the step at whose beginning `margin + room` is left, and at whose end it is not."""

    low: float
    high: float
    room: float = 0.0


class Watch:
    """Which margins of a mode were ever more than nothing, and how far the others may fall short of it."""

    def __init__(self, start: Sequence[float]) -> None:
        """`start` are the margins where the mode begins: those that are nothing are due when they come back."""
        self._armed = [margin > ARMED for margin in start]
        self._room = [ARMED - margin if -DRIFT < margin < 0.0 else ARMED if margin >= 0.0 else 0.0 for margin in start]

    def passed(self, after: Sequence[float]) -> None:
        """Note the margins at the end of a step in which nothing was due."""
        self._armed = [was or margin > ARMED for was, margin in zip(self._armed, after, strict=True)]

    def crossings(
        self, ends: Sequence[Sequence[float]], margins: Callable[[float], Sequence[float]]
    ) -> list[tuple[int, Crossing]]:
        """The first crossing of each margin that has one; `ends` are all margins at 0, ½ and 1 of the step."""
        known: dict[float, Sequence[float]] = {}

        def at(x: float) -> Sequence[float]:
            if x not in known:
                known[x] = margins(x)
            return known[x]

        found: list[tuple[int, Crossing]] = []
        for number, values in enumerate(zip(*ends, strict=True)):
            first, middle, last = values
            if min(values) <= abs(first - middle) + abs(middle - last):  # else it is more than all by which it changes
                crossing = self._first(number, values, lambda x, i=number: at(x)[i])
                if crossing is not None:
                    found.append((number, crossing))
        return found

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
            armed, last = armed or value > ARMED, x
        return None


def _dips(margin: Margin, samples: Sequence[Sample]) -> list[Sample]:
    """Points between samples at which a margin that is left at all of them is used up.

    Between two of them it dips where it falls at the first and rises at the second. There the tangents say how low it
    can be, as long as it is bent upwards: a point where they meet above zero settles that there is nothing.
    """
    found: list[Sample] = []
    for one, other in pairwise(samples):
        dip = _dip(margin, one, other)
        if dip is not None:
            found.append(dip)
    return found


def _dip(margin: Margin, one: Sample, other: Sample) -> Sample | None:
    (low, left), (high, right) = one, other
    falls, rises = _slope(margin, low, left, NEAR), _slope(margin, high, right, -NEAR)
    for _ in range(TANGENTS):
        if not falls < 0.0 < rises:
            return None
        meet = (left - right + rises * high - falls * low) / (rises - falls)
        if left + falls * (meet - low) > 0.0 or not low < meet < high:
            return None
        width = EDGE * (high - low)
        meet = min(max(meet, low + width), high - width)
        value = margin(meet)
        if value < 0.0:
            return meet, value
        slope = _slope(margin, meet, value, NEAR)
        if slope < 0.0:
            low, left, falls = meet, value, slope
        else:
            high, right, rises = meet, value, slope
    return None


def _slope(margin: Margin, x: float, value: float, step: float) -> float:
    return (margin(x + step) - value) / step


def _rise(margin: Margin, samples: Sequence[Sample]) -> list[Sample]:
    """A point at which a margin that begins at nothing was more than nothing before it is used up, if there is one."""
    x = next(x for x, value in samples if value < 0.0)
    for _ in range(HALVES):
        x *= 0.5
        value = margin(x)
        if value > ARMED:
            return [(x, value)]
    return []
