"""Event functions of a contact mode, each zero at its event, and the location of events within a step."""

from collections.abc import Callable, Iterator
from math import comb, sqrt
from typing import NamedTuple

import numpy as np

from sim2reason.errors import SimulationError
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.engines.mujoco.changing_equations.forces import (
    LARGE,
    NEVER,
    ContactMode,
    Faces,
    ForceSolution,
    SwitchState,
    active_set,
    solve_regular,
    system,
)
from sim2reason.simulation.engines.mujoco.changing_equations.model import ConstrainedModel
from sim2reason.simulation.engines.mujoco.changing_equations.record import PASSING_DISTANCE, Knot, MotionRecord, Quintic
from sim2reason.simulation.engines.mujoco.extrapolation import extrapolate_step

STEADY = 1e-6  # fraction of the largest acceleration: constant ones differ by less

DISTANCES = frozenset({"gap", "reach", "border", "strain"})
"""The kinds of margins that can dip below zero and rise again within a step."""


class EventMargin(NamedTuple):
    """The value of an event function, which is zero at the event, with its kind, index and side."""

    kind: str
    number: int
    side: int
    value: float


class ActingModel:
    """A model in one contact mode, with its rates, forces and event functions."""

    def __init__(
        self, model: ConstrainedModel, record: MotionRecord, situation: SwitchState, found: ForceSolution
    ) -> None:
        """Store the model, its contact mode and the forces at the start without computing anything."""
        self.model, self.record, self.situation, self.way, self._found = model, record, situation, found.way, found
        self.constant = model.constant
        self.rate = self._constant_rate if self.constant else self._rate()
        way = found.way
        self._unbound = not (way.rows or way.faces)  # nothing constrains it: no force is looked for
        rows = model.rows() if self.constant else []
        self._idle = [i for i, row in enumerate(rows) if not (row.both or way.rows[i])]

    def _constant_rate(self, time: float, values: Array) -> Array:
        """Return the time derivative of (q, v) where the accelerations are those at the start."""
        del time
        return np.concatenate([values[self.model.size :], self._found.x])

    def check(self) -> None:
        """Raise SimulationError if accelerations that are constant by the structure differ from those at the start."""
        if self.constant:
            now, started = self.forces().x, self._found.x
            if np.abs(now - started).max(initial=0.0) > STEADY * max(1.0, float(np.abs(started).max(initial=0.0))):
                raise SimulationError("MuJoCo: a force changes between two events")

    def _rate(self) -> Callable[[float, Array], Array]:
        """Return the function that computes the time derivative of (q, v)."""
        model, situation, way, n = self.model, self.situation, self.way, self.model.size
        faces, acts = Faces(model.rises, model.slips, model.friction), active_set(way, model.friction)
        free = not (acts.rows or acts.closed)

        def rate(time: float, values: Array) -> Array:
            model.stand(time, values[:n], values[n:], situation)
            if free:
                x = model.unheld(model.loads())
                return np.concatenate([values[n:], x if abs(x).max(initial=0.0) < LARGE else self.forces().x])
            rows = [model.row(number) for number in acts.rows]
            held, targets = [row.gradient for row in rows], [row.target for row in rows]
            if not acts.closed and not model.uneven:  # M⁻¹ of a nearly massless part would leave round-off
                x = model.held(model.loads(), np.array(held), np.array(targets))
                return np.concatenate([values[n:], x if x is not None else self.forces().x])
            matrix, wanted = system(model.inertia(), model.loads(), held, targets, faces, way, acts)
            found = solve_regular(matrix, wanted)
            x = found[:n] if found is not None else self.forces().x
            return np.concatenate([values[n:], x])

        return rate

    def forces(self) -> ForceSolution:
        """Return all forces at the present state of the model."""
        return self.record.forces(self.way)

    def knot(self, time: float, values: Array) -> tuple[Knot, list[EventMargin]]:
        """Return the record of the end of a step (time, state, rates), and all event functions there."""
        n = self.model.size
        if self.constant:
            self.model.stand(time, values[:n], values[n:], self.situation)
            return Knot(time, values, self.rate(time, values)), self.margins()
        if self._unbound:
            return Knot(time, values, self.rate(time, values)), self.margins()
        self.model.stand(time, values[:n], values[n:], self.situation)
        forces = self.forces()
        return Knot(time, values, np.concatenate([values[n:], forces.x])), self._margins(forces)

    def closeness(self, knot: Knot) -> float:
        """Return the factor by which a step tolerance shrinks because attracting bodies are close to each other.

        Without attraction the factor is 1.
        """
        if not self.model.mechanism.attractions:
            return 1.0
        n = self.model.size
        self.model.stand(knot.time, knot.values[:n], knot.values[n:], self.situation)
        return self.model.closeness()

    def margins(self) -> list[EventMargin]:
        """Return all event functions at the present state of the model."""
        if self.constant:
            return [*self._varying()]
        return [*self._places(), *self._switches()] if self._unbound else self._margins(self.forces())

    def _varying(self) -> Iterator[EventMargin]:
        """Yield the event functions that vary under constant forces, each a polynomial of time of degree ≤ 4."""
        for number in self._idle:
            yield EventMargin("spare", number, 0, self.model.row(number).spare)
        for number, side in enumerate(self.way.rubbing):
            if side:
                yield EventMargin("slip", number, side, side * float(self.model.slips[number] @ self.model.v))
        for due in self._places():
            meeting = self.model.mechanism.meetings[due.number] if due.kind == "gap" else None
            if meeting is not None and meeting.normal is None and meeting.distance > 0.0:  # the distance is no polynomial, but its square is
                due = due._replace(value=due.value * (1.0 + 0.5 * due.value / meeting.distance))
            yield due

    def _margins(self, forces: ForceSolution) -> list[EventMargin]:
        return [*self._rows(forces), *self._faces(forces), *self._places(), *self._switches()]

    def distances(self) -> list[EventMargin]:
        """Return the event functions that are distances, which require no forces."""
        return [due for due in [*self._places(), *self._switches()] if due.kind in DISTANCES]

    def _rows(self, forces: ForceSolution) -> Iterator[EventMargin]:
        for number, row in enumerate(self.model.rows()):
            if not row.both:
                acts = self.way.rows[number]
                yield EventMargin(
                    "force" if acts else "spare", number, 0, float(forces.rows[number]) if acts else row.spare
                )

    def _faces(self, forces: ForceSolution) -> Iterator[EventMargin]:
        model = self.model
        for number, face in enumerate(model.mechanism.faces):
            friction, normal = face.static_friction, float(forces.normal[number])
            if not face.guided:
                yield EventMargin("normal", number, 0, normal)
            side = self.way.rubbing[number]
            if side:
                yield EventMargin("slip", number, side, side * float(model.slips[number] @ model.v))
            elif 0.0 < friction < NEVER:
                held = float(forces.friction[number])
                yield EventMargin("grip", number, 1, friction * abs(normal) + held)
                yield EventMargin("grip", number, -1, friction * abs(normal) - held)

    def _places(self) -> Iterator[EventMargin]:
        model, mechanism = self.model, self.model.mechanism
        for number, meeting in enumerate(mechanism.meetings):
            if not self.situation.stuck[number]:
                yield EventMargin("gap", number, 0, model.separation(meeting)[0])
        for number in range(len(self.record.runs)):
            yield EventMargin("reach", number, 0, self.record.run_length(number))
        q = model.q[model.coordinates]
        for number, coordinate in enumerate(mechanism.coordinates):
            for side, room in ((-1, q[number] - coordinate.lower), (1, coordinate.upper - q[number])):
                if np.isfinite(room):
                    yield EventMargin("limit", number, side, float(room))

    def _switches(self) -> Iterator[EventMargin]:
        model, mechanism = self.model, self.model.mechanism
        for number, burning in enumerate(self.situation.burning):
            if burning:
                yield EventMargin("burn", number, 0, mechanism.burns[number].until - model.time)
        for number, strained in enumerate(self.situation.strained):
            strain = model.strain(number)[0]
            yield EventMargin("strain", number, 0, strain if strained else -strain)
        for number in range(len(mechanism.forces)):
            for side, margin in enumerate(model.borders(number)):
                yield EventMargin("border", number, side, margin if self.situation.inside[number][side] else -margin)


TOLERANCE = 2e-8  # relative tolerance of a step
DRIFT = 1e-5  # an event function may start this far below zero, as steps and impacts leave it
ARMED = 1e-7  # value that an event function that starts at or below zero must exceed before it can signal
TIE = 1e-7  # fraction of the duration: events closer than this are simultaneous
SOUGHT = 12  # attempts to end a step at an event
EVENT_TIME_RTOL = 1e-13  # fraction of the duration: accuracy of an event time
WIDTH = 1e-4  # fraction of a step: width of the finite difference for a slope
NARROW = 1e-7  # fraction of a step: width of the finite difference that decides the side of a minimum
FORESEEN = 1e-5  # fraction of a step: accuracy of the predicted end
HALVINGS = 30  # attempts to find a point of a step with a negative distance


def _room(margin: float, ready: bool) -> float:  # noqa: FBT001 - one of a pair
    """Return the depth below zero at which an event function signals an event; larger if it starts at or below zero."""
    if ready or margin < -DRIFT:
        return 0.0
    return ARMED + max(0.0, -margin)


FRACTIONS: Array = np.linspace(0.0, 1.0, 5)  # of a step, at which event functions under constant forces are evaluated
TO_POWERS: Array = np.linalg.inv(np.vander(FRACTIONS, increasing=True)).T  # from values there to coefficients of powers
TO_BERNSTEIN: Array = np.array([[comb(k, i) / comb(4, i) for k in range(5)] for i in range(5)])
"""From coefficients of powers to those of Bernstein polynomials, of which the least is a lower bound in the step."""
REAL = 1e-9  # a root with a smaller imaginary part is real
ROUNDING = 1e-13  # fraction of the largest coefficient of a polynomial: smaller ones are round-off


def _cleared(polynomial: Array) -> Array:
    """Return the polynomial without coefficients that are round-off."""
    return np.where(np.abs(polynomial) > ROUNDING * np.abs(polynomial).max(), polynomial, 0.0)


class EventSearch:
    """The search for events in a step, from the event functions at both ends and which were ever positive."""

    def __init__(
        self,
        acting: ActingModel,
        step: tuple[Knot, Knot],
        ends: tuple[list[EventMargin], list[EventMargin]],
        armed: list[bool],
    ) -> None:
        """Store the step without searching."""
        self._acting, self._step, self._ends, self._curve = acting, step, ends, Quintic(*step)
        self._room = [_room(due.value, ready) for due, ready in zip(ends[0], armed, strict=True)]
        self._span = step[1].time - step[0].time
        self._polynomials: Array | None = None  # of the event functions, (functions, powers), under constant forces
        if acting.constant:
            values = [ends[0], *(self._between(x) for x in FRACTIONS[1:-1].tolist()), ends[1]]
            self._polynomials = np.array([[due.value for due in each] for each in values]).T @ TO_POWERS

    def due(self, duration: float) -> tuple[Knot, list[EventMargin]] | None:
        """Return the step's end at its first event, and the event functions that signal it; None without event."""
        start, before = self._step[0], self._ends[0]
        if self._worst(before) < 0.0:
            return start, [due for due, r in zip(before, self._room, strict=True) if due.value + r < 0.0]
        x = self._foreseen(0.0)
        if x is None:
            return None
        if self._arm(0.5 * x):
            x = self._foreseen(0.5 * x) or x
        here, margins, tolerance = start, before, TOLERANCE * self._acting.closeness(start)
        for _ in range(SOUGHT):
            tried = extrapolate_step(
                self._acting.rate, start.time, start.values, start.rates, x * self._span, tolerance
            )
            here, margins = self._acting.knot(start.time + x * self._span, tried.values)
            change = self._change(x, margins)
            if abs(change) * self._span <= EVENT_TIME_RTOL * duration or not 0.0 < x + change <= 1.2:
                break
            x += change
        return here, self._simultaneous(x, margins, duration)

    def _change(self, x: float, margins: list[EventMargin]) -> float:
        """Return the Newton correction of the step fraction at which the least event function is zero.

        The approach speed of two points is known; once they separate, they have met before.
        """
        short = self._worst(margins)
        for due, room in zip(margins, self._room, strict=True):
            if due.kind == "reach" and due.value + room == short:
                rate = self._acting.record.run_rate(due.number) * self._span
                return -(short + (2.0 * PASSING_DISTANCE if rate > 0.0 else 0.0)) / rate if rate else 0.0
        slope = self._slope(x, margins)
        return -short / slope if slope else 0.0

    def _slope(self, x: float, margins: list[EventMargin]) -> float:
        """Return the derivative of the least event function at a fraction of the step."""
        if self._polynomials is None:
            return (self._left(x + WIDTH) - self._left(x - WIDTH)) / (2.0 * WIDTH)
        least = int(np.argmin([due.value + room for due, room in zip(margins, self._room, strict=True)]))
        return float(self._slopes(x)[least])

    def _slopes(self, x: float) -> Array:
        """Return the derivatives of all event functions at a fraction of the step; their means if these vary freely."""
        if self._polynomials is None:
            return np.array([b.value - a.value for a, b in zip(*self._ends, strict=True)])
        powers: Array = np.arange(1.0, len(TO_POWERS))
        return np.asarray(self._polynomials[:, 1:] @ (powers * x ** (powers - 1.0)), dtype=np.float64)

    def _arm(self, x: float) -> bool:
        """Update which event functions became positive by a fraction of the step; return whether any did."""
        risen = [room > 0.0 and due.value > ARMED for room, due in zip(self._room, self._between(x), strict=True)]
        self._room = [0.0 if rose else room for rose, room in zip(risen, self._room, strict=True)]
        return any(risen)

    def _simultaneous(self, x: float, margins: list[EventMargin], duration: float) -> list[EventMargin]:
        """Return the event functions that have reached zero, or will within the tolerance of simultaneous events."""
        near = [max(1e-9, TIE * duration * abs(slope) / self._span) for slope in self._slopes(x).tolist()]
        return [due for due, r, close in zip(margins, self._room, near, strict=True) if due.value + r <= close]

    def _worst(self, margins: list[EventMargin]) -> float:
        """Return the least value of all event functions; if two points of a line have met, that of their distance."""
        left = [(due.value + r, due.kind) for due, r in zip(margins, self._room, strict=True)]
        met = min((value for value, kind in left if kind == "reach"), default=1.0)
        return met if met < 0.0 else min(left, default=(1.0, ""))[0]

    def _foreseen(self, after: float) -> float | None:
        """Return the fraction of the step at which an event is predicted by interpolation; None if there is none.

        Under constant forces it is the first, and later than `after`.
        """
        if self._polynomials is not None:
            return self._first_root(self._polynomials, after)
        high = 0.5 if self._left(0.5) < 0.0 else 1.0
        if high == 1.0 and self._worst(self._ends[1]) >= 0.0:
            dip = self._dip()
            if dip is None:
                return None
            high = dip
        return self._crossing(0.0, high)

    def _first_root(self, polynomials: Array, after: float) -> float | None:
        """Return the first fraction of the step, later than `after`, at which a polynomial is zero; None if none is."""
        shifted = polynomials.copy()
        shifted[:, 0] += self._room
        found: list[float] = []
        for each in shifted[(shifted @ TO_BERNSTEIN).min(axis=1) < 0.0]:  # others are positive throughout the step
            roots = np.polynomial.polynomial.polyroots(np.trim_zeros(_cleared(each), "b"))
            real = roots.real[np.abs(roots.imag) <= REAL]
            found += [x for x in real.tolist() if after < x <= 1.0]
        return min(found, default=None)

    def _crossing(self, low: float, high: float) -> float:
        """Return the end of a short interval of the step in which the least event function changes sign.

        Guesses are those of C. Ridders, A new algorithm for computing a single root, IEEE Trans. Circuits Syst. 26
        (1979), and are bracketed at once.
        """
        left, over = self._left(low), self._left(high)
        while high - low > FORESEEN:
            middle = 0.5 * (low + high)
            value = self._left(middle)
            root = sqrt(max(value * value - left * over, 0.0))
            guess = middle + (middle - low) * (value / root if root else 0.0)
            low, high, left, over = (middle, high, value, over) if value > 0.0 else (low, middle, left, value)
            for x in (guess - 0.4 * FORESEEN, guess + 0.4 * FORESEEN):
                if low < x < high:
                    value = self._left(x)
                    low, high, left, over = (x, high, value, over) if value > 0.0 else (low, x, left, value)
        return high

    def _dip(self) -> float | None:
        """Return a fraction of the step at which a distance is negative though it is positive at both ends.

        It falls at the first and rises at the second, and the tangents there meet below zero, or two points of a line
        come together, which may bend the tangents the other way.
        """
        reach = [due.kind == "reach" for due in self._ends[0] if due.kind in DISTANCES]
        ends = [[due.value for due in each if due.kind in DISTANCES] for each in self._ends]
        if not ends[0]:
            return None
        falls = (np.array(self._distances(WIDTH)) - ends[0]) / WIDTH
        rises = (np.array(ends[1]) - self._distances(1.0 - WIDTH)) / WIDTH
        for number, (left, right, fall, rise, meets) in enumerate(zip(*ends, falls, rises, reach, strict=True)):
            if fall < 0.0 < rise:
                meet = (left - right + rise) / (rise - fall)
                if (meets or left + fall * meet < 0.0) and (found := self._bottom(number, float(meet))) is not None:
                    return found
        return None

    def _bottom(self, number: int, x: float) -> float | None:
        """Return a fraction of the step at which a distance is negative, sought from `x` along its slope; else None."""
        low, high = 0.0, 1.0
        for _ in range(HALVINGS):
            value, after = (self._distances(each)[number] for each in (x, x + NARROW))
            if value < 0.0:
                return x
            low, high = (x, high) if after < value else (low, x)
            x = 0.5 * (low + high)
        return None

    def _distances(self, x: float) -> list[float]:
        """Return the event functions that are distances at a fraction of the step."""
        self._stand(x)
        return [due.value for due in self._acting.distances()]

    def _left(self, x: float) -> float:
        """Return the least event function at a fraction of the step, by interpolation between its ends."""
        return self._worst(self._between(x))

    def _between(self, x: float) -> list[EventMargin]:
        """Return all event functions at a fraction of the step."""
        self._stand(x)
        return self._acting.margins()

    def _stand(self, x: float) -> None:
        time = self._step[0].time + x * self._span
        self._acting.model.stand(time, *self._curve.at(time), self._acting.situation)
