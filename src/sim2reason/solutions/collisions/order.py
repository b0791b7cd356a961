"""The order of collisions: proofs that no other pair collides before the next one, or after the last one."""

from collections.abc import Iterator
from dataclasses import replace
from math import inf

from sim2reason.scenes.dsl.mechanism import CollisionPair
from sim2reason.scenes.dsl.vectors import dot, subtract_triples
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol, multiply_factors, ratio, sum_terms
from sim2reason.solutions.algebra.functions import Absolute, Power, Root, sum_formulas, sum_of_squares
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.collisions.exclusions import (
    Exclusion,
    FreeInterval,
    Intervals,
    RelativeMotion,
    approach_sentence,
    clauses,
    last_collision_sentence,
    late_values,
)
from sim2reason.solutions.collisions.flights import Impact
from sim2reason.solutions.collisions.impacts import Impacts
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.writing.arrangement import ORDER
from sim2reason.solutions.writing.lexicon import DualValue
from sim2reason.solutions.writing.notation import METRES, SECONDS, SPEED, latex
from sim2reason.solutions.writing.steps import StepBuilder, record_inequality

MIN_RELATIVE_MOTION = 1e-12  # m/s or m²/s: smaller relative motions count as zero
SPEED_ATOL = 1e-9  # m/s: smaller velocities after a head-on collision are rounding errors


class CollisionOrder:
    """A writer of the reasons why no other pair collides before the next collision, up to a given time."""

    def __init__(self, flights: Impacts, time: float) -> None:
        """Take all flights and the end time, s, which may be infinite."""
        self._flights, self._book, self._time, self._held = flights, flights.book, time, Intervals(flights, time)
        self._until: Symbol | None = None
        self._first = len(self._book.steps)  # the number of the first step about these flights
        self._early = self._held.early

    def write_collisions(self) -> None:
        """Write all collisions before the end in the order of time."""
        for impact in self._early:
            time = self._flights.collision_time(impact)
            self._tell_all(impact, time)
            self._flights.after(impact)

    def _tell_all(self, impact: Impact, time: Symbol) -> None:
        """Write the positions and velocities of all discs just before a collision."""
        flights = self._flights
        if flights.mechanism.meetings[impact.meeting].normal is not None:
            return
        for body in flights.mechanism.bodies:
            number = flights.count(body.name, impact)
            for k in flights.coordinates(body.name):
                flights.displacement(body.name, number, k, time)
                flights.velocity(body.name, number, k, time)

    def write_exclusions(self, until: Symbol | None) -> None:
        """Write why no other bodies collide first: at the start, and after each collision where it is not obvious.

        `until` is the symbol of the end time; None if the motion has no end.
        """
        self._until = until
        for begins in (None, *self._early):
            self._write_noncolliding_pairs(begins)
            if begins is not None:
                self._tell_next(begins)

    def _write_noncolliding_pairs(self, begins: Impact | None) -> None:
        """Write which pairs of bodies do not collide, given the velocities after a collision or at the start.

        At the start they include bodies that would collide later, which proves that the first collision is the first.
        """
        step, exclusions = self._book.begin_step(ORDER), list[Exclusion]()
        for stretch in self._held:
            if stretch.begins == begins and (begins is None or not stretch.is_collision):
                exclusions += filter(None, [self._excluded(step, stretch)])
        last = begins if self._early and begins == self._early[-1] else None
        now, before = (
            [*late_values(self._flights, step)],
            last_collision_sentence(self._flights, step, last, self._until),
        )
        step.add_text(*(now if exclusions else ()), before, *(each.motion for each in exclusions))
        if exclusions:
            step.add_text(f"{self._lead(begins)} {'; '.join(clauses(exclusions))}{self._hence(begins)}.")
        if exclusions or before:
            self._close(step)

    def _tell_next(self, begins: Impact) -> None:
        """Write why two bodies collide next, unless the times of collisions show it."""
        step, following = self._book.begin_step(ORDER), self._held.next_collision(begins)
        if self._flights.timed or following is None:
            return
        own = (interval for interval in self._held if interval.begins == begins and self._held.is_late(interval))
        exclusions = [exclusion for interval in own if (exclusion := self._excluded(step, interval)) is not None]
        closing = approach_sentence(self._flights, step, begins, following)
        step.add_text(*late_values(self._flights, step))
        if exclusions:
            step.add_text(
                *(each.motion for each in exclusions), f"{self._lead(begins)} {'; '.join(clauses(exclusions))}."
            )
        step.add_text(closing)
        if exclusions or closing:
            self._close(step)

    def _close(self, step: StepBuilder) -> None:
        """Close a step about the order of collisions; record the number of the step before which it must not move."""
        step.close()
        self._book.earliest[self._book.steps[-1].id] = self._first

    # ---- why two do not meet

    def _excluded(self, step: StepBuilder, held: FreeInterval) -> Exclusion | None:
        """Return the argument why a pair does not collide in an interval; None if obvious or if it collides."""
        meets = held.is_collision and not self._held.is_late(held)
        meeting = self._flights.mechanism.meetings[held.meeting]
        just_met = held.begins is not None and held.begins.meeting == held.meeting
        if meets or any((body, leg) in self._flights.flights_to_moment for body, leg in held.legs.items()):
            return None
        if meeting.normal is None:
            return self._aside(step, held, meeting) if not just_met else self._touching(held)
        return self._in_line(step, held, just_met=just_met)

    def _touching(self, held: FreeInterval) -> Exclusion | None:
        """Return why two discs in contact after an inelastic collision do not collide again; else None."""
        flights = self._flights
        if flights.restitution(held.meeting):
            return None
        one, other = (
            [flights.flight_of_body(b, n).speeds[k] for k in flights.coordinates(b)] for b, n in held.legs.items()
        )
        relative_velocity = (self._book.value((w - v).expression()) for v, w in zip(one, other, strict=True))
        return self._excluded_by(
            "touching" if any(abs(u) > SPEED_ATOL for u in relative_velocity) else "together", held, ""
        )

    def _aside(self, step: StepBuilder, held: FreeInterval, meeting: CollisionPair) -> Exclusion | None:
        """Return the argument why two discs do not collide in an interval; None if they do not move."""
        flights, book = self._flights, self._book
        d = flights.setting.lexicon.formula_for(lambda m: m.meetings[held.meeting].distance).expression()
        parts = [part for part in self._relative(held, meeting) if any(map(book.value, part[1:]))]
        if max((abs(book.value(w)) for _, _, w in parts), default=0.0) < MIN_RELATIVE_MOTION:
            return None
        mark = flights.pair_mark(held.legs, held.begins)
        motion, more = RelativeMotion(book, step, mark), RelativeMotion(book, step, mark)
        X, u = zip(*((motion.named(a, x, METRES), motion.named("u", w, SPEED, a)) for a, x, w in parts), strict=True)
        square, along = sum_of_squares(u), sum_formulas(multiply_factors(x, w) for x, w in zip(X, u, strict=True))
        aside = multiply_factors(X[0], u[1]) - multiply_factors(X[1], u[0]) if len(X) > 1 else ZERO
        if book.value(along) >= 0.0:
            record_inequality(book, step, along, ZERO)
            exclusion = self._excluded_by("apart", held, motion.concluded("q", along, latex("m^2/s")))
        elif abs(book.value(aside)) >= book.value(Root(square)) * book.value(d):
            still = [x for x, w in zip(X, u, strict=True) if w == ZERO]
            closest = Absolute(still[0]) if still else ratio(Absolute(aside), Root(square))
            record_inequality(book, step, closest, d)
            exclusion = self._excluded_by("pass", held, motion.concluded("b", closest, METRES))
        else:
            p, q, c = (
                more.named(name, part, latex(unit))
                for name, part, unit in (("p", square, "m^2/s^2"), ("q", along, "m^2/s"), ("c", aside, "m^2/s"))
            )
            root = Root(
                sum_terms(multiply_factors(p, Power(d, 2)), -Power(c, 2))
                if c != ZERO
                else multiply_factors(p, Power(d, 2))
            )
            exclusion = self._later(motion, held, -ratio(sum_terms(q, root), p))
        one, other = map(flights.setting.display_name, meeting.names)
        sentence = f"Position and velocity of {other} relative to {one} {self._when(held)}: {join_words(motion.told)}"
        sentence += f"; hence {join_words(more.told)}." if more.told else "."
        return replace(exclusion, limit=d.latex(), motion=sentence)

    def _in_line(self, step: StepBuilder, held: FreeInterval, *, just_met: bool) -> Exclusion | None:
        """Return the argument why two bodies on a line, or a body and a wall, do not collide in an interval."""
        flights, book = self._flights, self._book
        ways, meeting = (
            flights.normal_coordinates(flights.mechanism.meetings[held.meeting]),
            flights.mechanism.meetings[held.meeting],
        )
        begin, gap, rate, rise = self._begin(held), flights.initial_gap(held.meeting), NIL, NIL
        for body, (k, sense) in ways.items():
            sign = sense * (1.0 if body == meeting.b else -1.0)
            displacement, velocity = self._drift(body, held.legs[body], k, begin)
            a = flights.acceleration(k).scale(sign)
            gap, rate, rise = gap + displacement.scale(sign), rate + velocity.scale(sign), rise + a
        rate, gap = rate + rise * begin, gap + (rise * begin * begin).scale(0.5)
        mark = flights.pair_mark(held.legs, held.begins)
        motion, speed = RelativeMotion(book, step, mark), book.value(rate.expression())
        if rise:
            return self._thrown(motion, held, (NIL if just_met else gap, rate, rise))
        if just_met or abs(speed) < MIN_RELATIVE_MOTION:
            return None
        if speed > 0.0:
            record_inequality(book, step, rate.expression(), ZERO)
            kind = "wall apart" if len(ways) == 1 else "line apart"
            exclusion = self._excluded_by(kind, held, motion.concluded("u", rate.expression(), SPEED))
            return replace(exclusion, limit=flights.obstacle(held.meeting))
        motion.named("d", gap.expression(), METRES)
        motion.named("u", rate.scale(-1.0).expression(), SPEED)
        return self._approaching(motion, held, motion.quotient(), " and approaching at")

    def _thrown(
        self, motion: RelativeMotion, held: FreeInterval, course: tuple[Polynomial, Polynomial, Polynomial]
    ) -> Exclusion | None:
        """Return why a body that accelerates relative to a wall does not reach it; None if it never could."""
        (gap, rate, rise), value = course, self._book.value
        d, u, a = (value(part.expression()) for part in course)
        planar = any(len(self._flights.coordinates(body)) > 1 for body in held.legs)
        if a > 0.0 and (gap or planar) and (u >= 0.0 or (gap and u * u < 2.0 * a * d)):
            return None
        distance = Polynomial.from_expression(motion.named("d", gap.expression(), METRES)) if gap else NIL
        change = Polynomial.from_expression(motion.named("u", rate.expression(), SPEED)) if u else NIL
        if gap:
            span = self._flights.root(distance, change, rise)
            return self._approaching(motion, held, span, ", a distance that at first changes at the rate")
        exclusion = self._later(motion, held, ratio(change.scale(-2.0).expression(), rise.expression()))
        obstacle = self._flights.obstacle(held.meeting)
        return replace(
            exclusion, aside=f"which leaves {obstacle} at {join_words(motion.told)}", limit=f"{obstacle} again"
        )

    def _approaching(self, motion: RelativeMotion, held: FreeInterval, span: Expression, moving: str) -> Exclusion:
        """Return the argument that a distance along a line vanishes only after the end of an interval."""
        pair, obstacle = len(held.legs) > 1, self._flights.obstacle(held.meeting)
        distance, *speed = motion.told
        aside = (
            f"{distance} {'apart' if pair else f'from {obstacle}'}{moving if speed else ''} {''.join(speed)}".strip()
        )
        return replace(self._later(motion, held, span), aside=aside, limit=obstacle)

    def _later(self, motion: RelativeMotion, held: FreeInterval, span: Expression) -> Exclusion:
        """Return the argument that two bodies would collide only after the interval, at a time since t = 0.

        If the two bodies do collide then, this proves that others collide before.
        """
        flights = self._flights
        ends = self._held.next_collision(held.begins) if held.is_collision else held.ends
        end = flights.collision_time(ends) if ends is not None else self._until
        assert end is not None
        lasts = sum_terms(self._begin(held).expression(), span)
        record_inequality(self._book, motion.step, lasts, self._since_start(end).expression())
        collision_time = span if held.begins is None else sum_terms(flights.collision_time(held.begins), span)
        oblique = flights.mechanism.meetings[held.meeting].normal is None
        kind = "later" if oblique else "wall later" if len(held.legs) == 1 else "line later"
        return self._excluded_by(kind, held, motion.concluded("t", collision_time, SECONDS))

    def _excluded_by(self, kind: str, held: FreeInterval, said: str) -> Exclusion:
        """Return the argument, of a given kind, that the two bodies of an interval do not collide."""
        return Exclusion(kind, self._flights.setting.bodies_phrase(list(held.legs)), self._letters(held), said)

    # ---- the motion without what gravity adds to all of it

    def _relative(self, held: FreeInterval, meeting: CollisionPair) -> Iterator[tuple[str, Expression, Expression]]:
        """Yield each axis with the relative position and velocity of a pair at the start of an interval."""
        flights = self._flights
        since = None if held.begins is None else flights.collision_time(held.begins)
        one, other = meeting.names
        places = [subtract_triples(f.center(other).place, f.center(one).place) for f in flights.frames]
        lexicon = flights.setting.lexicon
        for i, j in zip(flights.coordinates(one), flights.coordinates(other), strict=True):
            axes = lexicon.mechanism.coordinates[i].axis, lexicon.twin.coordinates[i].axis
            along = [float(dot(separation, axis)) for separation, axis in zip(places, axes, strict=True)]
            (s, v), (r, w) = (
                (flights.displacement(b, held.legs[b], k, since), flights.velocity(b, held.legs[b], k, since))
                for b, k in ((one, i), (other, j))
            )
            axis = flights.mechanism.coordinates[i].label
            yield axis, (lexicon.read(DualValue(*along)) + r - s).expression(), (w - v).expression()

    def _drift(self, body: str, number: int, k: int, time: Polynomial) -> tuple[Polynomial, Polynomial]:
        """Return displacement and velocity at a time of a flight, without the terms ½ a t² and a t of gravity."""
        flights, a = self._flights, self._flights.acceleration(k)
        displacement, before, velocity = NIL, NIL, NIL
        for n in range(number + 1):
            leg = flights.flight_of_body(body, n)
            begins = self._since_start(flights.begins(leg))
            displacement = displacement + velocity * (begins - before)
            velocity, before = leg.speeds[k] - a * begins, begins
        return displacement + velocity * (time - before), velocity

    def _begin(self, held: FreeInterval) -> Polynomial:
        """Return the time at which an interval begins."""
        return self._since_start(None if held.begins is None else self._flights.collision_time(held.begins))

    def _since_start(self, time: Symbol | None) -> Polynomial:
        """Return a time since t = 0 as a sum of the durations that have symbols in the text."""
        if time is None:
            return NIL
        if time in self._flights.sums:
            begins, span = self._flights.sums[time]
            return self._since_start(begins) + Polynomial.from_expression(span)
        return Polynomial.from_expression(time)

    # ---- words

    def _letters(self, held: FreeInterval) -> str:
        """Return the letters of the two bodies of an interval, such as *AB*."""
        return "".join(map(self._flights.setting.subscript_of, held.legs))

    def _when(self, held: FreeInterval) -> str:
        """Return words for the instant at which an interval begins, such as *at t = 0*."""
        if held.begins is None:
            return "at t = 0"
        return f"just after {self._flights.event(self._flights.collision_time(held.begins))}"

    def _lead(self, begins: Impact | None) -> str:
        """Return words that begin a sentence about the motion after a collision, or undisturbed from the start."""
        return (
            f"After {self._flights.event(self._flights.collision_time(begins))},"
            if begins is not None
            else "Undisturbed,"
        )

    def _hence(self, begins: Impact | None) -> str:
        """Return the last clause of a sentence: which pair collides first, or that no pair collides; may be empty."""
        following = self._flights.impacts[0] if begins is None and self._flights.impacts else None
        if following is not None and (self._time == inf or following.time <= self._time * (1.0 + 1e-9)):
            return f", so {self._meet(following)} first"
        if begins is not None and begins != self._early[-1]:
            return ""
        if self._until is None:
            return ", so there is no further collision"
        stated = self._until.name in self._book.stated
        until = f"${self._until.latex()}$" if stated else "the moment in question"
        return "" if self._held.at_end else f", so there is no further collision before {until}"

    def _meet(self, impact: Impact) -> str:
        """Return a clause about a collision, such as *carts A and B meet*."""
        met = self._flights.collision_clause(impact)
        return met[:1].lower() + met[1:]
