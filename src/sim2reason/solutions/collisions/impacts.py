"""Times of collisions and the velocities after them, written on demand."""

from abc import ABC, abstractmethod

from sim2reason.questions.words import ORDINALS
from sim2reason.scenes.dsl.mechanism import CollisionPair
from sim2reason.solutions.algebra.expressions import (
    ZERO,
    Expression,
    Number,
    Symbol,
    multiply_factors,
    ratio,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import Root, sum_of_squares
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.collisions.flights import ALIGNMENT_ATOL, FreeFlights, Impact
from sim2reason.solutions.setting import capitalized
from sim2reason.solutions.writing.notation import SECONDS, SPEED
from sim2reason.solutions.writing.steps import record_inequality, why_this_time


class Impacts(FreeFlights, ABC):
    """The collisions between free flights; subclasses solve those of discs in a plane."""

    @abstractmethod
    def discs_meet(self, impact: Impact) -> Symbol:
        """Write the time at which the rims of two moving discs first touch, in s, and return its symbol."""

    @abstractmethod
    def discs_part(self, impact: Impact) -> dict[int, Polynomial]:
        """Write the velocity components of two discs just after their collision, and return them by coordinate."""

    def collision_time(self, impact: Impact) -> Symbol:
        """Return the symbol of the time of a collision; on first use, write the time."""
        if impact.number not in self.times:
            self.times[impact.number] = self._meets(impact)
        return self.times[impact.number]

    def latest(self, impact: Impact) -> tuple[dict[str, int], Impact | None]:
        """Return, by body, the number of the flight that ends with a collision, and the latest collision before it."""
        legs = {body: self.count(body, impact) for body in impact.bodies}
        begun = [previous for b, n in legs.items() if (previous := self.flight_of_body(b, n).after) is not None]
        return legs, max(begun, key=lambda previous: previous.number, default=None)

    def _meets(self, impact: Impact) -> Symbol:
        """Write the time of a collision: that at which the gap closes, counted from the start of the later flight."""
        meeting = self.mechanism.meetings[impact.meeting]
        if meeting.normal is None:
            return self.discs_meet(impact)
        ways = self.normal_coordinates(meeting)
        legs, latest = self.latest(impact)
        since = self.collision_time(latest) if latest is not None else None
        gap, rate, rise = self.initial_gap(impact.meeting), NIL, NIL
        again = (
            latest is not None
            and latest.meeting == impact.meeting
            and all(self.flight_of_body(b, n).after == latest for b, n in legs.items())
        )
        for body, number in legs.items():
            k, sense = ways[body]
            sign = sense * (1.0 if body == meeting.b else -1.0)
            if not again:
                gap = gap + self.displacement(body, number, k, since).scale(sign)
            rate = rate + self.velocity(body, number, k, since).scale(sign)
            rise = rise + self.acceleration(k).scale(sign)
        return self._closed(impact, (NIL if again else gap, rate, rise), since)

    def _closed(
        self, impact: Impact, motion: tuple[Polynomial, Polynomial, Polynomial], since: Symbol | None
    ) -> Symbol:
        """Write the time at which a gap closes, given the gap, its rate and its acceleration."""
        gap, rate, rise = motion
        step, name = self.book.begin_step("impact time"), self.book.fresh("t")
        if not rise and any(self.acceleration(k) for body in impact.bodies for k in self.coordinates(body)):
            who = self.setting.bodies_phrase(list(impact.bodies))
            step.add_text(
                f"The acceleration of {who} is the same, so their relative velocity is constant until they meet."
            )
        t = Polynomial.from_expression(name)
        if not rise:
            law = step.law(gap.expression(), (rate.scale(-1.0) * t).collected((name.name,)))
            formula: Expression = ratio(gap.expression(), rate.scale(-1.0).expression())
        elif not gap:
            law = step.law(ZERO, (rate * t + (rise * t * t).scale(0.5)).expression())
            formula = ratio(rate.scale(-2.0).expression(), rise.expression())
        else:
            law = step.law(ZERO, (gap + rate * t + (rise * t * t).scale(0.5)).expression())
            formula = self.root(gap, rate, rise)
        later = self.counted_from(impact, since)
        result = step.result(name, formula, SECONDS)
        why = why_this_time(self.book, step, name, self.root(*motion, first=False)) if rate and rise and gap else ""
        step.add_text(f"{self.collision_clause(impact)} when {law}, so {result}{later}{why}.")
        step.close()
        return self.time_since_start(since, name)

    def counted_from(self, impact: Impact, since: Symbol | None) -> str:
        """Return words such as *, counted from t = 0* that say from when a time of collision counts; may be empty."""
        if since is None:
            return ", counted from t = 0" if impact.number else ""
        return f" after {self.event(since)}"

    def root(self, gap: Polynomial, rate: Polynomial, rise: Polynomial, *, first: bool = True) -> Expression:
        """Return the first root t of gap + rate t + ½ rise t² = 0; or the other root, if `rate` is not zero."""
        double = multiply_factors(Number(-2.0), multiply_factors(rise.expression(), gap.expression()))
        v = rate.expression()
        if not rate:
            return Root(ratio(gap.scale(-2.0).expression(), rise.expression()))
        root = Root(sum_terms(sum_of_squares([v]), double))
        root = root if first else -root
        if self.book.value(rise.expression()) < 0.0:
            return ratio(sum_terms(root, v), rise.scale(-1.0).expression())
        return ratio(sum_terms(-v, -root), rise.expression())

    def collision_clause(self, impact: Impact) -> str:
        """Return a clause about a collision, such as *Carts A and B meet again*."""
        again = " again" if any(earlier.meeting == impact.meeting for earlier in self.impacts[: impact.number]) else ""
        if len(impact.bodies) == 1:
            body = capitalized(self.setting.display_name(impact.bodies[0]))
            return f"{body} hits {self.obstacle(impact.meeting)}{again}"
        return f"{capitalized(self.setting.bodies_phrase(list(impact.bodies)))} meet{again}"

    def obstacle(self, meeting: int) -> str:
        """Return the words for a fixed obstacle, such as *the left wall*."""
        normal = self.mechanism.meetings[meeting].normal
        if normal is not None and normal[2] > 1.0 - ALIGNMENT_ATOL:
            return "the ground"
        normals = {pair.normal for pair in self.mechanism.meetings if pair.a is None}
        if normal is None or len(normals) == 1:
            return "the wall"
        x, y, z = normal
        if abs(y) > ALIGNMENT_ATOL:  # of a table, on which y points away from the reader or up the slope
            ends = ("lower", "upper") if abs(z) > ALIGNMENT_ATOL else ("near", "far")
            return f"the {ends[0] if y > 0.0 else ends[1]} wall"
        return "the left wall" if x > 0.0 else "the right wall"

    def event(self, time: Symbol) -> str:
        """Return the name of the collision at a time; *then* if there is none."""
        impact = next((self.impacts[n] for n, name in self.times.items() if name == time), None)
        return "then" if impact is None else self.collision(impact)

    def collision(self, impact: Impact) -> str:
        """Return the name of a collision, such as *the second impact of ball A on the ground*."""
        who = self.setting.bodies_phrase(list(impact.bodies))
        same = [other.number for other in self.impacts if other.meeting == impact.meeting]
        which = f"{_ordinal(same.index(impact.number) + 1)} " if len(same) > 1 else ""
        if len(impact.bodies) > 1:
            return f"the {which}collision of {who}"
        return f"the {which}impact of {who} on {self.obstacle(impact.meeting)}"

    def flying_on(self, body: str, number: int, time: Symbol) -> None:
        """Write that a body is still in the air at a time after its rebound from the ground."""
        leg, book = self.flight_of_body(body, number), self.book
        impact, begins = leg.after, self.begins(leg)
        if impact is None or begins is None or impact.bodies != (body,) or begins == time:
            return
        k, _ = self.normal_coordinates(self.mechanism.meetings[impact.meeting])[body]
        if not self.acceleration(k):
            return
        formula = ratio(leg.speeds[k].scale(-2.0).expression(), self.acceleration(k).expression())
        span = self.flight_duration(leg, time)
        if book.is_hidden(formula) or book.is_hidden(span):
            return
        obstacle, planar = self.obstacle(impact.meeting), len(self.coordinates(body)) > 1
        if planar and book.value(formula) <= 0.0:  # gravity pulls the body away from the wall
            return
        step, name = book.begin_step("verify"), book.fresh("t", r"\text{flight}")
        record_inequality(book, step, formula, span)
        self.flights_to_moment.add((body, number))
        step.rest_on(span.name)
        equation = step.verified(name, formula, SECONDS)
        if planar and obstacle != "the ground":
            step.add_text(
                f"It would hit {obstacle} again only {equation} after this impact, which is later than ${time.name}$."
            )
        else:
            step.add_text(
                f"It would land again only {equation} after this impact, so it is still in the air at ${time.name}$."
            )
        step.close()

    def after(self, impact: Impact) -> dict[int, Polynomial]:
        """Return the velocities of the colliding bodies just after a collision, by coordinate."""
        if impact.number not in self.velocities_after_impact:
            meeting = self.mechanism.meetings[impact.meeting]
            if meeting.normal is None:
                velocities = self.discs_part(impact)
            else:
                velocities = self._rebound(impact) if len(meeting.names) == 1 else self._collision(impact, meeting)
            for body in impact.bodies:
                for k in self.coordinates(body):
                    if k not in velocities:
                        velocities[k] = self.just_before(impact, body, k)
            self.velocities_after_impact[impact.number] = velocities
        return self.velocities_after_impact[impact.number]

    def just_before(self, impact: Impact, body: str, k: int) -> Polynomial:
        """Return the velocity along a coordinate just before a collision."""
        time = self.collision_time(impact) if self.acceleration(k) else None
        return self.velocity(body, self.count(body, impact), k, time)

    def restitution(self, number: int) -> Polynomial:
        """Return the coefficient of restitution of two bodies, or body and wall, that collide."""
        return self.setting.lexicon.formula_for(lambda m: m.meetings[number].restitution)

    def closing(self, impact: Impact) -> Expression:
        """Return the signed relative velocity along the normal just before a collision."""
        ways = self.normal_coordinates(self.mechanism.meetings[impact.meeting])
        speeds = [self.just_before(impact, body, k).scale(sense) for body, (k, sense) in ways.items()]
        return (speeds[0] - speeds[1] if len(speeds) > 1 else speeds[0]).expression()

    def effective_mass(self, impact: Impact) -> Expression:
        """Return the effective mass of a collision, kg: m against a wall, else the reduced mass m m′/(m + m′)."""
        masses = [self.mass(body).expression() for body in impact.bodies]
        return masses[0] if len(masses) == 1 else ratio(multiply_factors(*masses), sum_terms(*masses))

    def _rebound(self, impact: Impact) -> dict[int, Polynomial]:
        """Write the velocities after a collision with a wall."""
        body = impact.bodies[0]
        k, _ = self.normal_coordinates(self.mechanism.meetings[impact.meeting])[body]
        e, before = self.restitution(impact.meeting), self.just_before(impact, body, k)
        step, name = self.book.begin_step("rebound"), self.book.name_after_impact("v", self.motion_subscript(body, k))
        formula = (e * before).scale(-1.0).expression()
        met = self.collision_clause(impact).replace(" hits ", " rebounds from ")
        if impact.number in self.times:  # the text has just named the wall
            met = f"{capitalized(self.setting.display_name(body))} rebounds"
        step.add_text(f"{met} with {step.result(name, formula, SPEED, law=True)}{self._wall_velocity_clause(body, k)}.")
        step.close()
        return {k: Polynomial.from_expression(name)}

    def _wall_velocity_clause(self, body: str, k: int) -> str:
        """Return the clause that the velocity along a wall is unchanged; empty on a line or after a first rebound."""
        others = [j for j in self.coordinates(body) if j != k]
        if not others or any(step.kind == "rebound" for step in self.book.steps):
            return ""
        return f"; its velocity along {self.mechanism.coordinates[others[0]].label} stays the same"

    def _collision(self, impact: Impact, meeting: CollisionPair) -> dict[int, Polynomial]:
        """Write both velocities after a collision, by conservation of momentum and restitution."""
        ways = self.normal_coordinates(meeting)
        (one, (i, _)), (other, (j, _)) = ways.items()
        u, w = self.just_before(impact, one, i), self.just_before(impact, other, j)
        names = [self.book.name_after_impact("v", self.motion_subscript(body, k)) for body, (k, _) in ways.items()]
        m, n = (self.mass(body) for body in (one, other))
        e, step = self.restitution(impact.meeting), self.book.begin_step("impact")
        x, y = (Polynomial.from_expression(name) for name in names)
        momentum = step.law((m * u + n * w).expression(), (m * x + n * y).expression())
        parting = step.law((y - x).expression(), multiply_factors(e.expression(), (u - w).expression()))
        known = impact.number in self.times  # the text has just named the bodies
        if any(earlier.kind == "impact" for earlier in self.book.steps):
            step.add_text(f"{'As before' if known else self.collision_clause(impact)}: {momentum} and {parting}.")
        else:
            step.add_text("" if known else f"{self.collision_clause(impact)}.")
            step.add_text(f"Conservation of momentum and restitution: {momentum} and {parting}.")
        step.label(f"impact {impact.number}")
        step.close()
        total_mass = (m + n).expression()
        for name, heavy, sign in ((names[0], n, -1.0), (names[1], m, 1.0)):
            step = self.book.begin_step("solve")
            step.rest_on(f"impact {impact.number}")
            push = (heavy * e).scale(sign).expression()
            above = sum_terms((m * u + n * w).expression(), multiply_factors(push, (u - w).expression()))
            step.add_text(f"So {step.result(name, ratio(above, total_mass), SPEED)}.")
            step.close()
        return {i: Polynomial.from_expression(names[0]), j: Polynomial.from_expression(names[1])}


def _ordinal(number: int) -> str:
    """Return an ordinal in words, such as *first*; in digits if it is large, such as *7th*."""
    return ORDINALS[number - 1] if number <= len(ORDINALS) else f"{number}th"
