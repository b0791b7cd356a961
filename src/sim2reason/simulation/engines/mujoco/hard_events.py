"""Where within a step something is due: foreseen by the curve between its ends, found by steps of their own."""

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.simulation.engines.mujoco.extrapolation import extrapolated
from sim2reason.simulation.engines.mujoco.hard_margins import Acting, Due
from sim2reason.simulation.engines.mujoco.hard_record import Knot, between

TOLERANCE = 1e-7  # of a step, relative
ARMED = 1e-7  # what a margin that begins at zero must exceed before it can be due
TIE = 1e-7  # of the duration: events that are no further apart are simultaneous
SOUGHT = 12  # tries to end a step where something is due
CLOSE = 1e-13  # of the duration: how well an event is located
WIDTH = 1e-4  # of a step, over which a slope is taken


def knot(acting: Acting, time: float, values: Array) -> Knot:
    """The end of a step."""
    return Knot(time, values, acting.rate(time, values))


class EventSearch:
    """One step, its margins at both ends, and which of them were ever more than nothing."""

    def __init__(
        self, acting: Acting, step: tuple[Knot, Knot], ends: tuple[list[Due], list[Due]], armed: list[bool]
    ) -> None:
        """Nothing is searched yet."""
        self._acting, self._step, self._ends = acting, step, ends
        self._room = [0.0 if ready else ARMED for ready in armed]
        self._span = step[1].time - step[0].time

    def due(self, duration: float) -> tuple[Knot, list[Due]] | None:
        """The end of the step where something is due first, and what is; None if nothing is."""
        start, before = self._step[0], self._ends[0]
        if self._worst(before) < 0.0:
            return start, [due for due, r in zip(before, self._room, strict=True) if due.value + r < 0.0]
        x = self._foreseen()
        if x is None:
            return None
        here, margins = start, before
        for _ in range(SOUGHT):
            tried = extrapolated(self._acting.rate, start.time, start.values, start.rates, x * self._span, TOLERANCE)
            here = knot(self._acting, start.time + x * self._span, tried.values)
            margins = self._acting.margins()
            slope = (self._left(x + WIDTH) - self._left(x - WIDTH)) / (2.0 * WIDTH)
            change = -self._worst(margins) / slope if slope else 0.0
            if abs(change) * self._span <= CLOSE * duration or not 0.0 < x + change <= 1.2:
                break
            x += change
        return here, self._simultaneous(margins, duration)

    def _simultaneous(self, margins: list[Due], duration: float) -> list[Due]:
        """What is due, and what will be within a tie."""
        speeds = [abs(b.value - a.value) / self._span for a, b in zip(*self._ends, strict=True)]
        near = [max(1e-9, TIE * duration * speed) for speed in speeds]
        return [due for due, r, close in zip(margins, self._room, near, strict=True) if due.value + r <= close]

    def _worst(self, margins: list[Due]) -> float:
        """What is left of the margin that has least."""
        return min((due.value + r for due, r in zip(margins, self._room, strict=True)), default=1.0)

    def _foreseen(self) -> float | None:
        """The fraction of the step at which something is due, by the curve between its ends; None if nothing is."""
        high = 0.5 if self._left(0.5) < 0.0 else 1.0
        if high == 1.0 and self._worst(self._ends[1]) >= 0.0:
            return None
        low = 0.0
        while high - low > 1e-5:
            middle = 0.5 * (low + high)
            low, high = (middle, high) if self._left(middle) > 0.0 else (low, middle)
        return high

    def _left(self, x: float) -> float:
        """What is left of the worst margin at a fraction of the step, by the curve between its ends."""
        start, stop = self._step
        model = self._acting.model
        time = start.time + x * self._span
        values = between(start, stop, np.array([time]))[0]
        model.stand(time, values[: model.size], values[model.size :], self._acting.situation)
        return self._worst(self._acting.margins())
