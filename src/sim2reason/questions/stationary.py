"""Extremes of an answer as a function of one number of the scene."""

from collections.abc import Sequence
from itertools import pairwise
from math import isfinite
from typing import NamedTuple

from sim2reason.questions.dependence import AnswerFunction

FEW = 5  # values of the first pass; without a single reversal among them the search ends
STRIDE = 2  # stride through the values of the second pass
STEP = 0.01  # relative: step of finite differences
ROUNDS = 6  # iterations of Newton's method
FARTHEST = 0.2  # relative: largest total step
CONVERGENCE_RTOL, KNOWN_EXTREME_RTOL = 1e-8, 5e-7  # relative: tolerance of convergence; tolerance for a known extreme


class StationaryValue(NamedTuple):
    """An extreme: the value of the number, the answer there, and whether it is a maximum."""

    place: float
    value: float
    greatest: bool


class ExtremeSearch:
    """A search for the unique extreme of an answer as a function of a number."""

    def __init__(self, dependence: AnswerFunction) -> None:
        """Prepare the search, given the answer as a function of the number."""
        self._answer = dependence

    def among(self, values: Sequence[float]) -> StationaryValue | None:
        """Return the only extreme among at least three values in ascending order.

        None if there are several or none, or not all values have an answer.
        """
        coarse = [values[n * (len(values) - 1) // (FEW - 1)] for n in range(FEW)] if len(values) > FEW else values
        for some in (coarse, sorted({*coarse, *values[::STRIDE]})):
            turn = self._turn(some)
            if turn is None:
                return None
        low, middle, high, greatest = turn
        return self.near(_vertex([(at, self._answer(at) or 0.0) for at in (low, middle, high)]), greatest=greatest)

    def _turn(self, values: Sequence[float]) -> tuple[float, float, float, bool] | None:
        """Return three neighbouring values around the answer's only extreme, and whether it is a maximum; else None."""
        found = list[float]()
        for value in values:
            answer = self._answer(value)
            if answer is None or not isfinite(answer):
                return None
            found.append(answer)
        rises = [after > before for before, after in pairwise(found)]
        turns = [n for n, (one, other) in enumerate(pairwise(rises)) if one != other]
        if len(turns) != 1:
            return None
        n = turns[0]
        return values[n], values[n + 1], values[n + 2], rises[n]

    def near(self, about: float, *, greatest: bool) -> StationaryValue | None:
        """Return the extreme close to a value, by Newton's method; None if there is none."""
        at = about
        for turn in range(ROUNDS):
            step = STEP * abs(at)
            found = [self._answer(at + n * step) for n in (-2, -1, 0, 1, 2)]
            plain = [answer for answer in found if answer is not None and isfinite(answer)]
            if len(plain) < len(found):
                return None
            far_below, below, here, above, far_above = plain
            slope = (far_below - 8.0 * below + 8.0 * above - far_above) / (12.0 * step)
            bend = (16.0 * (below + above) - far_below - far_above - 30.0 * here) / (12.0 * step**2)
            if not (bend < 0.0 if greatest else bend > 0.0):
                return None
            shift = -slope / bend
            if abs(shift) > FARTHEST * abs(about):
                return None
            if turn == 0 and abs(shift) <= KNOWN_EXTREME_RTOL * abs(at):
                return StationaryValue(at, here, greatest)
            at += shift
            if abs(shift) <= CONVERGENCE_RTOL * abs(at):
                break
        value = self._answer(at)
        return StationaryValue(at, value, greatest) if value is not None else None


def _vertex(points: Sequence[tuple[float, float]]) -> float:
    """Return the position of the vertex of the parabola through three points."""
    (low, a), (middle, b), (high, c) = points
    left, right = (middle - low) * (b - c), (middle - high) * (b - a)
    return middle - 0.5 * ((middle - low) * left - (middle - high) * right) / (left - right)
