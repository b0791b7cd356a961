"""The motion of a mechanism whose equations change as it moves: integrated, with events located on the steps."""

from collections.abc import Callable, Sequence
from math import isfinite

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.errors import SimulationError
from sim2reason.simulation.engines.exact import dop853
from sim2reason.simulation.engines.exact.balance import Balance
from sim2reason.simulation.engines.exact.formulas import CurvedEquations, Formulas
from sim2reason.simulation.engines.exact.lengths import Phase
from sim2reason.simulation.engines.exact.margins import Stop
from sim2reason.simulation.engines.exact.roots import first_root
from sim2reason.simulation.engines.exact.system import Instant

TOLERANCE = (1e-13, 1e-11)  # of a step, absolute and relative
STEPS = 20_000
SHORTEST = 1e-13  # of the duration: a step below that is a singularity
ARMED = 1e-9  # what a margin that begins at zero must exceed before it can be due
TIE = 1e-10  # of the duration: events that are no further apart are simultaneous
POLISHES = 4  # corrections of an event's time by a step of the integrator itself
REST = 1e-11  # m/s or rad/s; what rounding leaves of a speed that is zero


class Step:
    """One step of the integrator, and what lies between its ends."""

    __slots__ = ("_polynomial", "formulas", "length", "new", "stages", "time", "values")

    def __init__(
        self, formulas: Formulas, time: float, length: float, values: dop853.Values, to: dop853.Advance
    ) -> None:
        """`values` are coordinates, then rates, at its beginning."""
        self.formulas, self.time, self.length, self.values = formulas, time, length, values
        self.new, self.stages = to.values, to.stages
        self._polynomial: tuple[dop853.Values, ...] | None = None

    @property
    def polynomial(self) -> tuple[dop853.Values, ...]:
        """The coefficients of its unknowns."""
        if self._polynomial is None:
            rate = self.formulas.rate
            self._polynomial = dop853.dense(rate, self.time, self.values, self.length, self.new, self.stages)
        return self._polynomial

    def at(self, x: float) -> list[float]:
        """Coordinates and rates at a fraction of the step."""
        return dop853.interpolated(self.values, self.polynomial, x)

    def margins(self, x: float) -> tuple[float, ...]:
        """All margins at a fraction of the step."""
        return self.formulas.margins(self.time + x * self.length, self.at(x))


class Flow:
    """The integration of one mode, from where it begins to what ends it."""

    def __init__(self, equations: CurvedEquations, instant: Instant, phase: Phase, found: Balance) -> None:
        """Write the code of the mode, if it is new."""
        self._equations, self._phase, self._mode = equations, phase, found.mode
        self.formulas = equations.formulas(instant, phase, found.mode)
        self.start = self.time = instant.time
        self.values: dop853.Values = (*instant.q, *instant.v)
        self.steps: list[Step] = []
        self.turns: list[tuple[float, int]] = []  # when a coordinate's speed passes through zero, and which

    def advance(self, duration: float, longest: float) -> Stop:
        """Go on for `duration`, s, or to the first event, or to where pivots must be chosen anew.

        `longest` is the duration of the whole motion. Raises SimulationError if the steps become too many or too short,
        or if something has no value.
        """
        try:
            return self._advance(duration, longest)
        except (ZeroDivisionError, OverflowError, ValueError):
            raise SimulationError(
                f"the motion becomes singular at {self.time:.6g} s; simulate a shorter time"
            ) from None
        except ArithmeticError:
            self._equations.forget(self._phase, self._mode)
            return Stop(self.time - self.start, ())

    def _advance(self, duration: float, longest: float) -> Stop:
        end, rate = self.start + duration, self.formulas.rate
        first = rate(self.time, self.values)
        before = self.formulas.margins(self.time, self.values)
        armed = [margin > ARMED for margin in before]
        length = dop853.first_step(rate, self.time, self.values, first, TOLERANCE)
        while self.time < end:
            length = min(length, end - self.time)
            self._check(length, end, longest)
            tried = dop853.advance(rate, self.time, self.values, first, length, TOLERANCE)
            if not tried.error <= 1.0:
                length *= min(0.5, dop853.factor(tried.error)) if isfinite(tried.error) else 0.1
                continue
            step = Step(self.formulas, self.time, length, self.values, tried)
            after = self.formulas.margins(step.time + length, tried.values)
            due = self._due(step, before, after, armed, TIE * longest)
            if due is not None:
                return due
            self._keep(step)
            first, before = tried.stages[-1], after
            armed = [was or margin > ARMED for was, margin in zip(armed, after, strict=True)]
            length *= dop853.factor(tried.error)
        return Stop(duration, ())

    def _check(self, length: float, end: float, longest: float) -> None:
        if length < SHORTEST * longest and end - self.time > SHORTEST * longest:
            raise SimulationError(f"the motion becomes singular at {self.time:.6g} s; simulate a shorter time")
        if len(self.steps) > STEPS:
            raise SimulationError(f"more than {STEPS} steps before {end:g} s; simulate a shorter time")

    def _keep(self, step: Step) -> None:
        self._note_turns(step)
        self.steps.append(step)
        self.time, self.values = step.time + step.length, step.new

    # ---- events

    def _due(
        self, step: Step, before: Sequence[float], after: Sequence[float], armed: Sequence[bool], tie: float
    ) -> Stop | None:
        """Take the step as far as the first event in it, if there is one."""
        slack = [0.0 if ready else ARMED for ready in armed]
        if not before:
            return None
        middle = step.margins(0.5)
        found: list[tuple[float, int]] = []
        for number, room in enumerate(slack):
            ends = (before[number] + room, middle[number] + room, after[number] + room)
            bracket = _bracket(ends, lambda x, i=number, r=room: step.margins(x)[i] + r)
            if bracket is not None:
                found.append((first_root(lambda x, i=number, r=room: step.margins(x)[i] + r, *bracket), number))
        if not found:
            return None
        soonest, leader = min(found)
        length = self._polished(step, soonest, leader, slack[leader])
        due = tuple(self.formulas.watched[i] for x, i in found if (x - soonest) * step.length <= tie)
        return Stop(self.time - self.start, due) if length >= 0.0 else None

    def _polished(self, step: Step, x: float, number: int, room: float) -> float:
        """Go on to an event, foreseen at a fraction of the step, by a step of its own; its length."""
        rate, first = self.formulas.rate, step.stages[0]
        width = 1e-4 * min(x, 1.0 - x) if 0.0 < x < 1.0 else 1e-6
        slope = (step.margins(x + width)[number] - step.margins(x - width)[number]) / (2.0 * width * step.length)
        length = x * step.length
        for _ in range(POLISHES):
            if length <= 0.0:
                return 0.0
            tried = dop853.advance(rate, step.time, step.values, first, length, TOLERANCE)
            missed = self.formulas.margins(step.time + length, tried.values)[number] + room
            change = -missed / slope if slope else 0.0
            if abs(change) <= 1e-15 * (step.time + length) or not 0.0 < length + change <= 1.5 * step.length:
                break
            length += change
        tried = dop853.advance(rate, step.time, step.values, first, length, TOLERANCE)
        self._keep(Step(self.formulas, step.time, length, step.values, tried))
        return length

    def _note_turns(self, step: Step) -> None:
        """Speeds that pass through zero within a step."""
        n = self._equations.system.size
        for number in range(n, 2 * n):
            old, new = step.values[number], step.new[number]
            if old * new < 0.0 and abs(old) > REST and abs(new) > REST:
                sign = 1.0 if old > 0.0 else -1.0
                x = first_root(lambda x, i=number, s=sign: s * step.at(x)[i], 0.0, 1.0)
                self.turns.append((step.time + x * step.length, number - n))


def _bracket(ends: tuple[float, float, float], function: Callable[[float], float]) -> tuple[float, float] | None:
    """An interval of the step at whose beginning a margin is left, and at whose end it is not; None if there is none.

    Where all three known values are positive, a parabola through them says where to look for a dip.
    """
    first, middle, last = ends
    if first < 0.0:
        return (0.0, 0.0)
    if middle < 0.0:
        return (0.0, 0.5)
    if last < 0.0:
        return (0.5, 1.0)
    bend = 2.0 * (first - 2.0 * middle + last)
    slope = -3.0 * first + 4.0 * middle - last
    if bend <= 0.0:
        return None
    lowest = -slope / (2.0 * bend)
    least = first + slope * lowest + bend * lowest * lowest
    if not 0.0 < lowest < 1.0 or least > 0.25 * min(ends):
        return None
    return (0.0, lowest) if function(lowest) < 0.0 else None


def sampled(flow: Flow, times: Array) -> Array:
    """Coordinates and rates at times within a flow, (m, 2n)."""
    starts = np.array([step.time for step in flow.steps])
    at = np.maximum(np.searchsorted(starts, times, side="right") - 1, 0)
    used = np.unique(at)
    place = np.searchsorted(used, at)
    steps = [flow.steps[int(number)] for number in used]
    since = (times - starts[at]) / np.array([step.length for step in steps])[place]
    x = since[:, None]
    y = 1.0 - x
    a, b, c, d, e, f, g = np.array([step.polynomial for step in steps]).transpose(2, 0, 1)[:, place]
    rise = x * (a + y * (b + x * (c + y * (d + x * (e + y * (f + x * g))))))
    found: Array = np.array([step.values for step in steps])[place] + rise
    return found
