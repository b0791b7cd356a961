"""The location of events within a step."""

from math import comb, sqrt

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.integration import Knot, Quintic, extrapolate_step
from sim2reason.simulation.engines.mujoco.margins import ActingModel, EventFunction
from sim2reason.simulation.engines.mujoco.record import PASSING_DISTANCE

STEP_RTOL = 2e-8  # relative tolerance of a step
MARGIN_DRIFT = 1e-5  # an event function may start this far below zero, as steps and impacts leave it
ARMING_MARGIN = 1e-7  # value that an event function that starts at or below zero must exceed before it can signal
SIMULTANEITY_RTOL = 1e-7  # fraction of the duration: events closer than this are simultaneous
MAX_END_ATTEMPTS = 12  # attempts to end a step at an event
EVENT_TIME_RTOL = 1e-13  # fraction of the duration: accuracy of an event time
SLOPE_STEP = 1e-4  # fraction of a step: width of the finite difference for a slope
MINIMUM_SLOPE_STEP = 1e-7  # fraction of a step: width of the finite difference that decides the side of a minimum
PREDICTED_END_RTOL = 1e-5  # fraction of a step: accuracy of the predicted end
MAX_HALVINGS = 30  # attempts to find a point of a step with a negative distance

FRACTIONS: Array = np.arange(5.0) / 4.0  # of a step, at which event functions under constant forces are evaluated
TO_POWERS: Array = np.linalg.inv(np.vander(FRACTIONS, increasing=True)).T.astype(np.float64)  # values to coefficients
TO_BERNSTEIN: Array = np.array([[comb(k, i) / comb(4, i) for k in range(5)] for i in range(5)])
"""From coefficients of powers to those of Bernstein polynomials, of which the least is a lower bound in the step."""
REAL_ROOT_TOL = 1e-9  # a root with a smaller imaginary part is real
COEFFICIENT_RTOL = 1e-13  # fraction of the largest coefficient of a polynomial: smaller ones are round-off


def _depth(margin: float, ready: bool) -> float:  # noqa: FBT001 - one of a pair
    """Return the depth below zero at which an event function signals an event; larger if it starts at or below zero."""
    if ready or margin < -MARGIN_DRIFT:
        return 0.0
    return ARMING_MARGIN + max(0.0, -margin)


def _roots(polynomial: Array) -> list[float]:
    """Return the real roots of a polynomial, whose highest powers may be round-off."""
    sizes = np.abs(polynomial)
    degree = int(np.flatnonzero(sizes > COEFFICIENT_RTOL * sizes.max())[-1])
    roots = np.polynomial.polynomial.polyroots(polynomial[: degree + 1])
    return [float(root.real) for root in roots if abs(root.imag) <= REAL_ROOT_TOL]


class EventSearch:
    """The search for events in a step, from the event functions at both ends and which were ever positive."""

    def __init__(
        self,
        acting: ActingModel,
        step: tuple[Knot, Knot],
        ends: tuple[list[float], list[float]],
        armed: list[bool],
    ) -> None:
        """Store the step without searching."""
        self._acting, self._step, self._ends, self._curve = acting, step, ends, Quintic(*step)
        self._reaches = [place for place, event in enumerate(acting.events) if event.kind == "reach"]
        self._depth = [_depth(value, ready) for value, ready in zip(ends[0], armed, strict=True)]
        self._span = step[1].time - step[0].time
        self._polynomials: Array | None = None  # of the event functions, (functions, powers), under constant forces
        if acting.constant:
            values = [ends[0], *(self._margins_at(x) for x in FRACTIONS[1:-1].tolist()), ends[1]]
            self._polynomials = np.array(values).T @ TO_POWERS

    def due(self, duration: float) -> tuple[Knot, list[EventFunction]] | None:
        """Return the step's end at its first event, and the event functions that signal it; None without event."""
        start, before = self._step[0], self._ends[0]
        if self._acting.unbound and not (before or self._acting.constant):
            self._acting.model.spend()  # as a search that looks at one state
            return None
        if self._least(before) < 0.0:
            events = zip(self._acting.events, before, self._depth, strict=True)
            return start, [event for event, value, r in events if value + r < 0.0]
        x = self._predict(0.0)
        if x is None:
            return None
        if self._arm(0.5 * x):
            x = self._predict(0.5 * x) or x
        here, margins, tolerance = start, before, STEP_RTOL * self._acting.closeness(start)
        for _ in range(MAX_END_ATTEMPTS):
            trial = extrapolate_step(
                self._acting.rate, start.time, start.values, start.rates, x * self._span, tolerance
            )
            here, margins = self._acting.knot(start.time + x * self._span, trial.values)
            change = self._change(x, margins)
            if abs(change) * self._span <= EVENT_TIME_RTOL * duration or not 0.0 < x + change <= 1.2:
                break
            x += change
        return here, self._simultaneous(x, margins, duration)

    def _change(self, x: float, margins: list[float]) -> float:
        """Return the Newton correction of the step fraction at which the least event function is zero.

        The approach speed of two points is known; once they separate, they have met before.
        """
        short = self._least(margins)
        for place in self._reaches:
            if margins[place] + self._depth[place] == short:
                rate = self._acting.record.run_rate(self._acting.events[place].number) * self._span
                return -(short + (2.0 * PASSING_DISTANCE if rate > 0.0 else 0.0)) / rate if rate else 0.0
        slope = self._slope(x, margins)
        return -short / slope if slope else 0.0

    def _slope(self, x: float, margins: list[float]) -> float:
        """Return the derivative of the least event function at a fraction of the step."""
        if self._polynomials is None:
            return (self._least_margin_at(x + SLOPE_STEP) - self._least_margin_at(x - SLOPE_STEP)) / (2.0 * SLOPE_STEP)
        least = int(np.argmin([value + room for value, room in zip(margins, self._depth, strict=True)]))
        return float(self._slopes(x)[least])

    def _slopes(self, x: float) -> Array:
        """Return the derivatives of all event functions at a fraction of the step; their means if these vary freely."""
        if self._polynomials is None:
            return np.array([b - a for a, b in zip(*self._ends, strict=True)])
        powers: Array = np.arange(1.0, len(TO_POWERS))
        return np.asarray(self._polynomials[:, 1:] @ (powers * x ** (powers - 1.0)), dtype=np.float64)

    def _arm(self, x: float) -> bool:
        """Update which event functions became positive by a fraction of the step; return whether any did."""
        risen = [
            room > 0.0 and value > ARMING_MARGIN for room, value in zip(self._depth, self._margins_at(x), strict=True)
        ]
        self._depth = [0.0 if rose else room for rose, room in zip(risen, self._depth, strict=True)]
        return any(risen)

    def _simultaneous(self, x: float, margins: list[float], duration: float) -> list[EventFunction]:
        """Return the event functions that have reached zero, or will within the tolerance of simultaneous events."""
        near = [max(1e-9, SIMULTANEITY_RTOL * duration * abs(slope) / self._span) for slope in self._slopes(x).tolist()]
        events = zip(self._acting.events, margins, self._depth, near, strict=True)
        return [event for event, value, r, close in events if value + r <= close]

    def _least(self, margins: list[float]) -> float:
        """Return the least value of all event functions; if two points of a line have met, that of their distance."""
        left = [value + r for value, r in zip(margins, self._depth, strict=True)]
        met = min((left[place] for place in self._reaches), default=1.0)
        return met if met < 0.0 else min(left, default=1.0)

    def _predict(self, after: float) -> float | None:
        """Return the fraction of the step at which an event is predicted by interpolation; None if there is none.

        Under constant forces it is the first, and later than `after`.
        """
        if self._polynomials is not None:
            return self._first_root(self._polynomials, after)
        high = 0.5 if self._least_margin_at(0.5) < 0.0 else 1.0
        if high == 1.0 and self._least(self._ends[1]) >= 0.0:
            dip = self._dip()
            if dip is None:
                return None
            high = dip
        return self._crossing(0.0, high)

    def _first_root(self, polynomials: Array, after: float) -> float | None:
        """Return the first fraction of the step, later than `after`, at which a polynomial is zero; None if none is."""
        shifted = polynomials.copy()
        shifted[:, 0] += self._depth
        doubtful = shifted[(shifted @ TO_BERNSTEIN).min(axis=1) < 0.0]  # others are positive throughout the step
        return min((x for each in doubtful for x in _roots(each) if after < x <= 1.0), default=None)

    def _crossing(self, low: float, high: float) -> float:
        """Return the end of a short interval of the step in which the least event function changes sign.

        Guesses are those of C. Ridders, A new algorithm for computing a single root, IEEE Trans. Circuits Syst. 26
        (1979), and are bracketed at once.
        """
        left, over = self._least_margin_at(low), self._least_margin_at(high)
        while high - low > PREDICTED_END_RTOL:
            middle = 0.5 * (low + high)
            value = self._least_margin_at(middle)
            root = sqrt(max(value * value - left * over, 0.0))
            guess = middle + (middle - low) * (value / root if root else 0.0)
            low, high, left, over = (middle, high, value, over) if value > 0.0 else (low, middle, left, value)
            for x in (guess - 0.4 * PREDICTED_END_RTOL, guess + 0.4 * PREDICTED_END_RTOL):
                if low < x < high:
                    value = self._least_margin_at(x)
                    low, high, left, over = (x, high, value, over) if value > 0.0 else (low, x, left, value)
        return high

    def _dip(self) -> float | None:
        """Return a fraction of the step at which a distance is negative though it is positive at both ends.

        It falls at the first and rises at the second, and the tangents there meet below zero, or two points of a line
        come together, which may bend the tangents the other way.
        """
        acting, events = self._acting, self._acting.events
        reach = acting.distances_among([event.kind == "reach" for event in events])
        ends = [acting.distances_among(each) for each in self._ends]
        if not reach:
            return None
        falls = [(later - left) / SLOPE_STEP for later, left in zip(self._distances(SLOPE_STEP), ends[0], strict=True)]
        if not any(fall < 0.0 for fall in falls):
            acting.model.spend()
            return None
        before = self._distances(1.0 - SLOPE_STEP)
        rises = [(right - earlier) / SLOPE_STEP for right, earlier in zip(ends[1], before, strict=True)]
        for number, (left, right, fall, rise, meets) in enumerate(zip(*ends, falls, rises, reach, strict=True)):
            if fall < 0.0 < rise:
                meet = (left - right + rise) / (rise - fall)
                if (meets or left + fall * meet < 0.0) and (fraction := self._bottom(number, meet)) is not None:
                    return fraction
        return None

    def _bottom(self, number: int, x: float) -> float | None:
        """Return a fraction of the step at which a distance is negative, sought from `x` along its slope; else None."""
        low, high = 0.0, 1.0
        for _ in range(MAX_HALVINGS):
            value, after = (self._distances(each)[number] for each in (x, x + MINIMUM_SLOPE_STEP))
            if value < 0.0:
                return x
            low, high = (x, high) if after < value else (low, x)
            x = 0.5 * (low + high)
        return None

    def _distances(self, x: float) -> list[float]:
        """Return the event functions that are distances at a fraction of the step."""
        self._set_state(x)
        return self._acting.distances()

    def _least_margin_at(self, x: float) -> float:
        """Return the least event function at a fraction of the step, by interpolation between its ends."""
        return self._least(self._margins_at(x))

    def _margins_at(self, x: float) -> list[float]:
        """Return the values of all event functions at a fraction of the step."""
        self._set_state(x)
        return self._acting.margins()

    def _set_state(self, x: float) -> None:
        time = self._step[0].time + x * self._span
        self._acting.model.set_state(time, *self._curve.at(time), self._acting.switches)
