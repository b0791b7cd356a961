"""Positions and velocities of bodies in free flight between collisions, written on demand."""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.scenes.dsl.frames import Frames, initial_frames
from sim2reason.scenes.dsl.mechanism import CollisionPair
from sim2reason.scenes.dsl.vectors import Vector, dot
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol, sum_terms
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.setting import ProblemContext
from sim2reason.solutions.writing.arrangement import DISPLACEMENT, TIME, VELOCITY, gap_at_start
from sim2reason.solutions.writing.notation import METRES, SECONDS, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError


@dataclass
class Flight:
    """A free flight: its start time (None for t = 0), and its initial velocities and positions by coordinate."""

    begins: Symbol | None
    speeds: Mapping[int, Polynomial]
    places: dict[int, Polynomial] = field(default_factory=dict[int, Polynomial])
    after: "Impact | None" = None


@dataclass(frozen=True)
class Impact:
    """A collision: its index in the motion, time in s and bodies, and the index of this pair in the mechanism."""

    number: int
    time: float  # s
    bodies: tuple[str, ...]
    meeting: int


ALIGNMENT_ATOL = 1e-9  # a unit vector's component, or its difference from 1, below which directions are aligned


class FreeFlights(ABC):
    """The free flights of all bodies in a motion; subclasses add the collisions between them."""

    def __init__(self, setting: ProblemContext, book: SolutionBuilder, *, timed: bool = False) -> None:
        """Take the problem and the solution in progress; UnsolvedError if bodies interact between collisions.

        With `timed`, all collisions get their times, so that the text proceeds from one to the next.
        """
        self.setting, self.book, self.mechanism, self.timed = setting, book, setting.mechanism, timed
        m = self.mechanism
        if m.lines or m.faces or m.forces or m.attractions or m.burns or m.feet:
            raise UnsolvedError("bodies act on each other between collisions")
        if any(c.kind != "slide" for c in m.coordinates) or any(b.parent is not None for b in m.bodies):
            raise UnsolvedError("a body turns, or rides on another")
        self._legs: dict[str, list[Flight]] = {}
        self.times: dict[int, Symbol] = {}
        self._spans: dict[tuple[str, str], Symbol] = {}
        self._speeds: dict[tuple[int, int, str], Polynomial] = {}
        self._places: dict[tuple[int, int, str], Polynomial] = {}
        self.velocities_after_impact: dict[int, dict[int, Polynomial]] = {}
        self.sums: dict[
            Symbol, tuple[Symbol, Symbol]
        ] = {}  # for times since the start: the flight's start time and duration
        self.flights_to_moment: set[tuple[str, int]] = set()  # flights stated to last until the moment
        self.relative: dict[
            int, tuple[list[Expression], list[Expression], Symbol | None, list[str]]
        ] = {}  # relative motion of colliding discs
        self.approaches: dict[int, tuple[dict[str, Symbol], Symbol]] = {}

    # ---- numbers

    @cached_property
    def frames(self) -> tuple[Frames, Frames]:
        """Return the initial geometry of the mechanism and of its twin, the same mechanism with other parameters."""
        return initial_frames(self.setting.lexicon.mechanism), initial_frames(self.setting.lexicon.twin)

    @cached_property
    def impacts(self) -> list[Impact]:
        """Return all collisions of the motion in order."""
        events = [e for e in self.setting.motion.events if e.kind == "collision"]
        return [Impact(n, e.time, e.subjects, self._meeting(e.subjects, e.time)) for n, e in enumerate(events)]

    def _meeting(self, bodies: tuple[str, ...], time: float) -> int:
        """Return the index of the pair, two bodies or body and wall, that collides; of two walls, the nearer one."""
        candidates = [n for n, met in enumerate(self.mechanism.meetings) if set(met.names) == set(bodies)]
        if len(candidates) == 1:
            return candidates[0]
        state = self.setting.study.trace.sample(np.array([time]))
        places = {b: state.vector(state.frames.center(b).place)[0] for b in bodies}

        def gap(n: int) -> float:
            met = self.mechanism.meetings[n]
            assert met.normal is not None
            return abs(float(places[met.b] @ met.normal) - met.distance)

        return min(candidates, key=gap)

    def coordinates(self, body: str) -> dict[int, Vector]:
        """Return the directions of a body's coordinates by index."""
        m = self.mechanism
        return {m.number[c.name]: c.axis for c in m.body[body].coordinates}

    def acceleration(self, k: int) -> Polynomial:
        """Return the gravitational acceleration along a coordinate."""
        lexicon = self.setting.lexicon
        return lexicon.formula_for(lambda m: -m.gravity[2]) * lexicon.formula_for(lambda m: -m.coordinates[k].axis[2])

    def mass(self, body: str) -> Polynomial:
        """Return the mass of a body."""
        return self.setting.lexicon.formula_for(lambda m: m.body[body].mass)

    def _first(self, body: str) -> Flight:
        """Return the initial flight of a body."""
        read = self.setting.lexicon.formula_for
        return Flight(None, {k: read(lambda m, k=k: m.coordinates[k].speed) for k in self.coordinates(body)})

    def flight_of_body(self, body: str, number: int) -> Flight:
        """Return the flight of a body that follows a given number of its collisions."""
        legs = self._legs.setdefault(body, [self._first(body)])
        while len(legs) <= number:
            own = [impact for impact in self.impacts if body in impact.bodies]
            impact = own[len(legs) - 1]
            if self.timed:
                self.collision_time(impact)
            legs.append(Flight(None, self.after(impact), after=impact))
        return legs[number]

    def count(self, body: str, impact: Impact | None) -> int:
        """Return the number of a body's collisions before a given one; for None, before the moment of the question."""
        limit = len(self.impacts) if impact is None else impact.number
        early = self.impacts[:limit]
        if impact is None:
            early = [collision for collision in early if collision.time < self.setting.time]
        return sum(body in collision.bodies for collision in early)

    def pair_mark(self, bodies: Iterable[str], begins: Impact | None) -> str:
        """Return the subscript of the relative motion of a pair: its letters and a collision number.

        The motion is that just after this collision; at t = 0 there is no number.
        """
        letters = "".join(map(self.setting.subscript_of, bodies))
        return letters if begins is None else f"{letters},{begins.number + 1}"

    @abstractmethod
    def collision_time(self, impact: Impact) -> Symbol:
        """Return the symbol of the time of a collision; on first use, write the time."""

    @abstractmethod
    def event(self, time: Symbol) -> str:
        """Return the name of the collision that happens at a given time."""

    @abstractmethod
    def after(self, impact: Impact) -> dict[int, Polynomial]:
        """Return the velocities of the colliding bodies just after a collision, by coordinate."""

    # ---- along a flight

    def begins(self, leg: Flight) -> Symbol | None:
        """Return the time at which a flight begins; None at t = 0."""
        return self.collision_time(leg.after) if leg.after is not None else None

    def flight_duration(self, leg: Flight, time: Symbol) -> Symbol:
        """Return the duration of a flight up to a time."""
        begins = self.begins(leg)
        if begins is None:
            return time
        return self.time_between(begins, time)

    def time_between(self, begins: Symbol, time: Symbol) -> Symbol:
        """Return the duration between two times."""
        key = (begins.name, time.name)
        if key not in self._spans:
            step, name = self.book.begin_step(TIME), self.book.fresh("t")
            formula = (Polynomial.from_expression(time) - Polynomial.from_expression(begins)).expression()
            step.add_text(f"The time since {self.event(begins)} is {step.result(name, formula, SECONDS, law=True)}.")
            step.close()
            self._spans[key] = name
        return self._spans[key]

    def time_since_start(self, begins: Symbol | None, span: Symbol) -> Symbol:
        """Return the time since t = 0 from a duration that begins at another time."""
        if begins is None:
            return span
        step, until = self.book.begin_step(TIME), self.book.fresh("t")
        step.add_text(f"The time since the start is {step.result(until, sum_terms(begins, span), SECONDS, law=True)}.")
        step.close()
        self._spans[begins.name, until.name], self.sums[until] = span, (begins, span)
        return until

    def velocity(self, body: str, number: int, k: int, time: Symbol | None) -> Polynomial:
        """Return the velocity along a coordinate at a time of a flight; for None, at its beginning."""
        leg, a = self.flight_of_body(body, number), self.acceleration(k)
        if not a or time is None or (leg.after is not None and self.begins(leg) == time):
            return leg.speeds[k]
        key = (k, number, time.name)
        if key not in self._speeds:
            span = self.flight_duration(leg, time)
            step, name = self.book.begin_step(VELOCITY), self.book.fresh("v", self.motion_subscript(body, k))
            formula = (leg.speeds[k] + a * Polynomial.from_expression(span)).expression()
            step.rest_on(time.name)
            step.add_text(f"At ${time.name}$ {self._whose(body, k)} {step.result(name, formula, SPEED, law=True)}.")
            step.close()
            self._speeds[key] = Polynomial.from_expression(name)
        return self._speeds[key]

    def displacement(self, body: str, number: int, k: int, time: Symbol | None) -> Polynomial:
        """Return the displacement along a coordinate since t = 0 at a time of a flight; for None, at its beginning."""
        if number == 0 and time is None:
            return NIL
        leg = self.flight_of_body(body, number)
        begins = self.begins(leg)
        there = self._at_wall(body, k, begins if time is None else time)
        if there is not None:
            return there
        if time is None or begins == time:
            time = begins
            assert time is not None
            return self.displacement(body, number - 1, k, time) if number else NIL
        key = (k, number, time.name)
        if key not in self._places:
            self._places[key] = self._moved(body, number, k, time)
        return self._places[key]

    def _at_wall(self, body: str, k: int, time: Symbol | None) -> Polynomial | None:
        """Return the displacement at which a body hits a wall at a time; None if it hits none then."""
        number = next((n for n, name in self.times.items() if name == time), None)
        if number is None or self.impacts[number].bodies != (body,):
            return None
        meeting = self.impacts[number].meeting
        ways = self.normal_coordinates(self.mechanism.meetings[meeting])
        return self.initial_gap(meeting).scale(-ways[body][1]) if ways[body][0] == k else None

    def _moved(self, body: str, number: int, k: int, time: Symbol) -> Polynomial:
        """Write the displacement along a coordinate at a time of a flight, and return it."""
        leg, a = self.flight_of_body(body, number), self.acceleration(k)
        steady = (
            number > 0 and not a and all(self.flight_of_body(body, n).speeds[k] == leg.speeds[k] for n in range(number))
        )
        before = ZERO if steady else self.displacement(body, number, k, None).expression()
        speed = leg.speeds[k].expression()
        if steady:
            formula = speed * time
        elif a:
            span = Polynomial.from_expression(self.flight_duration(leg, time))
            formula = before + (leg.speeds[k] * span + (a * span * span).scale(0.5)).expression()
        else:
            formula = before + speed * self._lasting(leg, time)
        if formula == ZERO:
            return NIL
        mark = ",".join(part for part in (self.motion_subscript(body, k), self._instant(time)) if part)
        step, name = self.book.begin_step(DISPLACEMENT), self.book.fresh("s", mark)
        whose = "" if len(self.mechanism.coordinates) > 1 else f" of {self.setting.display_name(body)}"
        says = f"At ${time.name}$ the displacement{whose} is"
        says = f"The velocity{self._axis(k)} is constant, so a{says[1:]}" if steady else says
        step.rest_on(time.name)
        step.add_text(f"{says} {step.result(name, formula, METRES, law=True)}.")
        step.close()
        return Polynomial.from_expression(name)

    def _instant(self, time: Symbol) -> str:
        """Return a collision number as a subscript if discs collide obliquely at a time; empty at other times."""
        impact = next((self.impacts[n] for n, name in self.times.items() if name == time), None)
        oblique = impact is not None and self.mechanism.meetings[impact.meeting].normal is None
        return self.collision_number(impact) if impact is not None and oblique else ""

    def collision_number(self, impact: Impact) -> str:
        """Return the number of a collision, as a subscript; empty for the only one before the question's moment."""
        several = sum(collision.time <= self.setting.time for collision in self.impacts) > 1
        return str(impact.number + 1) if several else ""

    def _lasting(self, leg: Flight, time: Symbol) -> Expression:
        """Return the duration of a flight up to a time: its symbol if it has one, else the time minus its beginning."""
        begins = self.begins(leg)
        if begins is None:
            return time
        return self._spans.get((begins.name, time.name)) or time - begins

    def _axis(self, k: int) -> str:
        """Return the words for the axis of a coordinate; empty if the body of the coordinate has only one axis."""
        label = self.mechanism.coordinates[k].label
        several = len(self.mechanism.body[self.mechanism.coordinates[k].body].coordinates) > 1
        upward = " (upward)" if self.mechanism.coordinates[k].axis[2] > 1.0 - ALIGNMENT_ATOL else ""
        return f" along {label}{upward}" if several else ""

    def motion_subscript(self, body: str, k: int) -> str:
        """Return the subscript of a body's quantities along a coordinate: the axis, then the body."""
        mark, label = self.setting.subscript_of(body), self.mechanism.coordinates[k].label
        several = len(self.mechanism.body[body].coordinates) > 1
        return ",".join(part for part in (label if several else "", mark) if part)

    def _whose(self, body: str, k: int) -> str:
        """Return the words before the formula of a velocity, such as *the velocity of puck A along x is*."""
        return f"the velocity of {self.setting.display_name(body)}{self._axis(k)} is"

    # ---- what they meet

    def normal_coordinates(self, meeting: CollisionPair) -> dict[str, tuple[int, float]]:
        """Return, by body, the coordinate along the normal of a collision and its sign; UnsolvedError if oblique."""
        if meeting.normal is None:
            raise UnsolvedError("the bodies meet at an angle")
        coordinates: dict[str, tuple[int, float]] = {}
        for body in meeting.names:
            for k, axis in self.coordinates(body).items():
                along = dot(axis, meeting.normal)
                if abs(along) > 1.0 - ALIGNMENT_ATOL:
                    coordinates[body] = (k, 1.0 if along > 0.0 else -1.0)
                elif abs(along) > ALIGNMENT_ATOL:
                    raise UnsolvedError("a wall stands at an angle to the motion")
        return coordinates

    def initial_gap(self, number: int) -> Polynomial:
        """Return the initial gap between two bodies, or body and wall, that may collide."""
        return gap_at_start(self.setting.lexicon, self.frames, number)
