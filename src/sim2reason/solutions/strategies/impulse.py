"""Impulse: free flights and collisions, by momentum and restitution at each relevant impact."""

from collections.abc import Sequence
from math import inf

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.questions.difficulty import Need
from sim2reason.questions.moments.bounces import Bounced, Landed
from sim2reason.questions.moments.contacts import Collided, LastCollision
from sim2reason.questions.moments.distances import Away, Moved
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.questions.moments.turning_points import HighestPoint, Stopped
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol, ratio, sum_terms
from sim2reason.solutions.algebra.functions import Power, Root
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.algebra.root_finding import root_sentence
from sim2reason.solutions.collisions.flights import Flight, Impact
from sim2reason.solutions.collisions.free_flight import (
    FlightPart,
    StruckBodies,
    height_at_rest,
    question_at_top,
    write_highest_point,
    write_nearer_before,
    write_omitted_collisions,
)
from sim2reason.solutions.collisions.oblique import Flights, write_nearer_side
from sim2reason.solutions.collisions.order import CollisionOrder
from sim2reason.solutions.goals import CollisionTerm, MotionPart
from sim2reason.solutions.laws.newton import Newton
from sim2reason.solutions.laws.straight_way import StraightMotion
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.strategies import Strategy, missing_goal, strategy, varying_acceleration
from sim2reason.solutions.writing.notation import METRES, SECONDS, SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, UnsolvedError, why_this_time

MOMENTS = (AtStart, AtTime, Collided, Bounced, Moved, Stopped, HighestPoint, Away, Landed, LastCollision)


@strategy
class Impulse(Strategy):
    """The strategy for bodies in free flight between collisions."""

    name = "impulse"
    cost = 0.8
    kinds = frozenset({"start", "state", "event", "time_to_event", "sum", "extremum"})

    def why_unsuitable(self, mechanism: Mechanism) -> str:
        """Return the reason, in words, that the strategy cannot apply to a mechanism; empty if it may apply."""
        return varying_acceleration(mechanism)

    def formulas(self, mechanism: Mechanism) -> frozenset[str]:
        """Return the question kinds that have a compact formula: all, or none if discs collide obliquely."""
        oblique = any(meeting.normal is None for meeting in mechanism.meetings)
        return frozenset[str]() if oblique else self.kinds

    def why_not_applicable(self, setting: ProblemContext) -> str:
        """Return the reason, in words, that the strategy does not apply to a question; empty if it applies."""
        if setting.query.kind == "extremum":
            return "" if question_at_top(setting) is not None else "it is no extreme value at the top of a path"
        return missing_goal(setting, MOMENTS)

    def write(self, setting: ProblemContext, book: SolutionBuilder) -> str:
        """Write the flights and impacts that the answer needs, and return the answer's symbol."""
        return _Struck(question_at_top(setting) or setting, book).write()


class _Struck(StraightMotion):
    """The motion of colliding bodies, as flights between impacts."""

    @cached_property
    def flights(self) -> Flights:
        """Return all flights."""
        return Flights(self.setting, self.book, timed=self.uses == "s")

    @property
    def newton(self) -> Newton:
        """Return Newton's laws, for masses and directions alone."""
        return self._newton

    @cached_property
    def _newton(self) -> Newton:
        return Newton(self.setting.lexicon, self.setting.motion.segments[0])

    def write(self) -> str:
        """Write the time or the quantity that is asked for, and return its symbol."""
        if not self.book.in_symbols and self.setting.most == Need.INTEGRATION:
            self._follow()
        if isinstance(self.query.moment, HighestPoint) and self.uses == "v":
            write_highest_point(self.flights, self.query.moment.name)
        answer = self.time if self.target is None or self.goal is None else self.goal.write(self.target, self)
        met = self.impact.bodies if self.impact is not None else ()
        write_omitted_collisions(
            self.flights, {*met, *(self.goal.bodies(self.target) if self.goal and self.target else ())}
        )
        return answer.name

    def _follow(self) -> None:
        """Write all collisions before the moment in order, and schedule the exclusion of others."""
        ever = isinstance(self.query.moment, LastCollision)
        until = self.time if isinstance(self.query.moment, AtTime) else None
        order = CollisionOrder(self.flights, inf if ever else self.setting.time)
        order.write_collisions()
        until = None if ever else until or self.time
        self.book.afterwards.append(lambda: order.write_exclusions(until))

    def force(self, kind: str, name: str) -> Symbol:
        """Raise UnsolvedError, since no contact acts in flight."""
        raise UnsolvedError(f"no {kind} of {name} in flight")

    @property
    def impacts(self) -> Sequence[CollisionTerm]:
        """Return all collisions up to and including the moment."""
        relevant = [impact for impact in self.flights.impacts if impact.time <= self.setting.time]
        return [StruckBodies(self.flights, impact) for impact in relevant]

    @property
    def motion_parts(self) -> Sequence[MotionPart]:
        """Return all flights of the body in question, each as a part of the motion."""
        assert self.target is not None
        body, flights = self.target.subject, self.flights
        last = self.number(body)
        ends = [flights.flight_of_body(body, number + 1).after for number in range(last)]
        times = [*(flights.collision_time(impact) if impact is not None else None for impact in ends), self.time]
        return [FlightPart(flights, number, time) for number, time in enumerate(times)]

    @cached_property
    def _flying(self) -> set[str]:
        """Return the names of the bodies for which the text already verifies that they still fly at the moment."""
        return set()

    # ---- the moment

    @cached_property
    def impact(self) -> Impact | None:
        """Return the impact to which the moment refers; None if it refers to none."""
        moment = self.query.moment
        if isinstance(moment, LastCollision):
            return [candidate for candidate in self.flights.impacts if candidate.time <= self.setting.time][-1]
        if not isinstance(moment, Collided | Bounced):
            return None
        bodies = set(moment.subjects)
        same = [candidate for candidate in self.flights.impacts if set(candidate.bodies) == bodies]
        if len(same) < moment.number:
            raise UnsolvedError("the motion ends before that collision")
        return same[moment.number - 1]

    @cached_property
    def time(self) -> Symbol:
        """Write the time of the moment, s, and return its symbol."""
        moment = self.query.moment
        if self.impact is not None:
            return self.flights.collision_time(self.impact)
        if isinstance(moment, AtTime):
            name = self.book.fresh("t")
            self.book.state_given(name.name, moment.after, SECONDS)
            return name
        if isinstance(moment, Moved):
            return self._after_distance(moment)
        if isinstance(moment, HighestPoint | Stopped):
            return self._turning(moment.name)
        if isinstance(moment, Away):
            return self._at_distance(moment)
        if isinstance(moment, Landed):
            return self._landing(moment.name)
        raise UnsolvedError("there is no such moment in flight")

    def number(self, body: str) -> int:
        """Return the index of a body's flight at the moment; at an impact, of the flight before or after, as asked."""
        if self.impact is None:
            return self.flights.count(body, None)
        moment = self.query.moment
        after = isinstance(moment, LastCollision) or (isinstance(moment, Collided | Bounced) and moment.after)
        return self.flights.count(body, self.impact) + (1 if after and body in self.impact.bodies else 0)

    def rate(self, kind: str, k: int) -> Polynomial:
        """Return the acceleration, velocity or displacement of a coordinate at the moment."""
        body = self.mechanism.coordinates[k].body
        if kind == "a":
            return self.flights.acceleration(k)
        turning = isinstance(self.query.moment, HighestPoint | Stopped) and body == self.query.moment.name
        if turning and self.flights.acceleration(k):
            top = isinstance(self.query.moment, HighestPoint)
            return NIL if kind == "v" else height_at_rest(self.flights, body, k, top=top)
        number = self.number(body)
        if isinstance(self.query.moment, AtTime) and body not in self._flying:
            self._flying.add(body)
            self.flights.flying_on(body, number, self.time)
        if kind == "s":
            return self.flights.displacement(body, number, k, self.time)
        needs_time = self.flights.acceleration(k) and not isinstance(self.query.moment, AtStart)
        return self.flights.velocity(body, number, k, self.time if needs_time else None)

    def _after_distance(self, moment: Moved) -> Symbol:
        """Write the time at which a body has moved a stated distance and return its symbol."""
        k, *_ = self.moving([moment.name])
        name = self.book.fresh("d")
        self.book.state_given(name.name, moment.value, METRES)
        number = self.flights.count(moment.name, None)
        leg = self.flights.flight_of_body(moment.name, number)
        there = float(self.setting.motion.state(np.array([self.setting.time])).q[0, k])
        before = self.flights.displacement(moment.name, number, k, None)
        target = Polynomial.from_expression(name).scale(1.0 if there > 0.0 else -1.0)
        if number and not self.flights.acceleration(k):
            write_nearer_side(self.flights, moment.name, k, name)
        text = f"{capitalized(moment.told(self.setting.words, f'${name.name}$'))} when"
        return self._flown(leg.speeds[k], (before - target, target), k, text, leg)

    def _landing(self, body: str) -> Symbol:
        """Write the time at which a body reaches the ground and return its symbol."""
        k = next(k for k in self.moving([body]) if self.mechanism.coordinates[k].lower > -inf)
        height = self.setting.lexicon.formula_for(lambda m: -m.coordinates[k].lower)
        leg = self.flights.flight_of_body(body, self.flights.count(body, None))
        text = f"{capitalized(self.setting.display_name(body))} reaches the ground when"
        return self._flown(leg.speeds[k], (height, NIL), k, text, leg)

    def _at_distance(self, moment: Away) -> Symbol:
        """Write the time at which a body is at a stated distance from its start; a numerical root."""
        body, number = moment.name, self.flights.count(moment.name, None)
        leg, name = self.flights.flight_of_body(body, number), self.book.fresh("d")
        self.book.state_given(name.name, moment.value, METRES)
        paths: list[Polynomial] = []
        moves = self.moving([body])
        if number == 0 and not any(self.flights.acceleration(k) for k in moves):
            return self._straight([leg.speeds[k] for k in moves if k in leg.speeds], name, body)
        before = {k: self.flights.displacement(body, number, k, None) for k in moves}
        write_nearer_before(self.flights, body, leg, name)
        step, time = self.book.begin_step("time"), self.book.fresh("t")
        t = Polynomial.from_expression(time)
        for k in moves:
            path = before[k] + leg.speeds[k] * t + (self.flights.acceleration(k) * t * t).scale(0.5)
            paths.append(path)
        squares: Expression = ZERO
        for path in paths:
            squares = sum_terms(squares, Power(path.expression(), 2))
        law = step.law(Power(name, 2), squares)
        begins = self.flights.begins(leg)
        near = self.setting.time - (self.book.values[begins.name] if begins is not None else 0.0)
        residual = sum_terms(squares, -Power(name, 2))
        step.add_text(f"{capitalized(self.setting.display_name(body))} is at the distance ${name.name}$ when {law}.")
        text = "The numerical solution for the first such time is"
        step.add_text(root_sentence(self.book, step, time, residual, near, SECONDS, text))
        step.close()
        return self.flights.time_since_start(self.flights.begins(leg), time)

    def _straight(self, speeds: list[Polynomial], distance: Symbol, body: str) -> Symbol:
        """Write the time to cover a distance at constant velocity and return its symbol."""
        squares: Expression = ZERO
        for speed in speeds:
            squares = sum_terms(squares, Power(speed.expression(), 2))
        step, speed, time = self.book.begin_step("time"), self.book.fresh("v"), self.book.fresh("t")
        fast = step.result(speed, Root(squares), SPEED, law=True)
        step.add_text(f"Until then the speed of {self.setting.display_name(body)} is constant, {fast},")
        step.add_text(f"so that {step.result(time, ratio(distance, speed), SECONDS, law=True)}.")
        step.close()
        return time

    def _turning(self, body: str) -> Symbol:
        """Write the time at which the velocity of a body along its line is zero and return its symbol."""
        coordinates = [k for k in self.moving([body]) if self.flights.acceleration(k)]
        if len(coordinates) != 1:
            raise UnsolvedError("nothing turns it back")
        k, number = coordinates[0], self.flights.count(body, None)
        leg = self.flights.flight_of_body(body, number)
        step, name = self.book.begin_step("time"), self.book.fresh("t")
        a = self.flights.acceleration(k)
        law = step.law((leg.speeds[k] + a * Polynomial.from_expression(name)).expression(), NIL.expression())
        formula = ratio(leg.speeds[k].scale(-1.0).expression(), a.expression())
        who = capitalized(self.setting.display_name(body))
        turns = "reaches its highest point" if isinstance(self.query.moment, HighestPoint) else "comes to rest"
        step.add_text(f"{who} {turns} when {law}, so {step.result(name, formula, SECONDS)}.")
        step.close()
        return self.flights.time_since_start(self.flights.begins(leg), name)

    def _flown(self, speed: Polynomial, way: tuple[Polynomial, Polynomial], k: int, said: str, leg: Flight) -> Symbol:
        """Write the time at which a coordinate reaches a target; `way` has start minus target, and the target."""
        (gap, target), a = way, self.flights.acceleration(k)
        parts: tuple[Polynomial, Polynomial, Polynomial] | None = None
        step, name = self.book.begin_step("time"), self.book.fresh("t")
        t = Polynomial.from_expression(name)
        law = step.law((gap + target + speed * t + (a * t * t).scale(0.5)).expression(), target.expression())
        if a and not gap:  # it comes back to where it began
            formula = ratio(speed.scale(-2.0).expression(), a.expression())
        elif a:
            # gap and rise have opposite signs unless it is thrown back; the first root in either case
            sign = 1.0 if self.book.value(gap.expression()) > 0.0 else -1.0
            parts = gap.scale(sign), speed.scale(sign), a.scale(sign)
            formula = self.flights.root(*parts)
        else:
            formula = ratio(gap.scale(-1.0).expression(), speed.expression())
        later = f" after {self.flights.collision(leg.after)}" if leg.after is not None else ""
        result = step.result(name, formula, SECONDS)
        why = why_this_time(self.book, step, name, self.flights.root(*parts, first=False)) if parts and speed else ""
        step.add_text(f"{said} {law}, so {result}{later}{why}.")
        step.close()
        return self.flights.time_since_start(self.flights.begins(leg), name)
