"""Highest points of trajectories, sums over flights, and collisions without influence on the answer."""

from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace

from sim2reason.questions import KINDS, Query
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.aggregates import Extreme
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.turning_points import HighestPoint
from sim2reason.questions.query import Target
from sim2reason.solutions.algebra.expressions import (
    ONE,
    ZERO,
    Expression,
    Number,
    Symbol,
    multiply_factors,
    ratio,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import Absolute, Power, Root, sum_of_squares
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.collisions.flights import ALIGNMENT_ATOL, Flight, Impact
from sim2reason.solutions.collisions.impacts import Impacts
from sim2reason.solutions.collisions.oblique import Flights
from sim2reason.solutions.goals import MotionPart
from sim2reason.solutions.goals.kinematics import squared
from sim2reason.solutions.setting import ProblemContext, capitalized
from sim2reason.solutions.writing.notation import METRES
from sim2reason.solutions.writing.steps import UnsolvedError, record_inequality

BOUNDS = (("s", r"\text{top}"), ("d", r"\text{max}"))  # names of the highest point and of the largest possible distance


def write_nearer_before(flights: Impacts, body: str, leg: Flight, distance: Symbol) -> None:
    """Write that, before a flight, a body was nearer to its start than a distance, by bounds on its coordinates.

    No other step depends on it; nothing is written if the corner is too far away, or for unknown numbers.
    """
    impact, begins, book = leg.after, flights.begins(leg), flights.book
    if impact is None or begins is None or impact.bodies != (body,):
        return
    k, _ = flights.normal_coordinates(flights.mechanism.meetings[impact.meeting])[body]
    level = [j for j in flights.coordinates(body) if j != k]
    if not flights.acceleration(k) or len(level) != 1 or flights.acceleration(level[0]):
        return
    along = flights.displacement(body, flights.count(body, impact) + 1, level[0], begins).expression()
    drop = flights.initial_gap(impact.meeting).expression()
    top = _top(flights, body, k)
    height = drop if top is None or book.value(top) <= book.value(drop) else top
    corner = Root(sum_of_squares([along, height]))
    if book.is_hidden(corner) or book.value(corner) >= book.value(distance):
        return
    step, names = book.begin_step("verify"), [book.fresh(base, mark) for base, mark in BOUNDS]
    record_inequality(book, step, distance, corner)
    rise = "it never rises above its starting point"
    if top is not None:
        record_inequality(book, step, height, ZERO if top == height else top)
        rise = f"it rises to {step.verified(names[0], top, METRES)} above its starting point"
    size = Absolute(along) if book.value(along) < 0.0 else along
    step.add_text(
        f"Until ${begins.name}$ the horizontal displacement of {flights.setting.display_name(body)} is at most"
    )
    step.add_text(
        f"${size.latex()}$ and, as {rise}, the vertical one at most ${height.latex()}$; so its distance from there"
    )
    step.add_text(f"is at most {step.verified(names[1], corner, METRES)}, less than ${distance.name}$.")
    step.close()


def _top(flights: Impacts, body: str, k: int) -> Expression | None:
    """Return the maximum height of a body above its start; None if it does not rise."""
    speed, fall = flights.flight_of_body(body, 0).speeds[k], flights.acceleration(k).scale(-2.0)
    rises = bool(speed) and flights.book.value(speed.expression()) > 0.0
    return Power(speed.expression(), 2) / fall.expression() if rises else None


@dataclass(frozen=True, slots=True)
class StruckBodies:
    """A collision as a term of a sum over a motion: its energy loss, its impulse and its bodies."""

    flights: Flights
    impact: Impact

    @property
    def bodies(self) -> tuple[str, ...]:
        """Return the names of the colliding bodies."""
        return self.impact.bodies

    @property
    def collision_name(self) -> str:
        """Return the name of the collision, such as *the second collision of A and B*."""
        return self.flights.collision(self.impact)

    @property
    def energy_loss_lead(self) -> str:
        """Return the first words of a sentence that gives an energy loss: the reason why kinetic energy is lost."""
        motion = "relative motion" if len(self.bodies) > 1 else "motion perpendicular to the surface"
        left = "keeps $e^2$ of its energy" if self.flights.restitution(self.impact.meeting) else "ends"
        return f"The {motion}{self._line_of_centres_words} {left}, so"

    @property
    def impulse_lead(self) -> str:
        """Return the first words of a sentence that gives an impulse: the laws from which the impulse follows."""
        e, pair = self.flights.restitution(self.impact.meeting), len(self.bodies) > 1
        if not pair:
            return "The impulse is the change of momentum, so"
        if e:
            return f"By conservation of momentum and restitution{self._line_of_centres_words},"
        return f"By conservation of momentum, as no relative velocity{self._line_of_centres_words} is left,"

    @property
    def _line_of_centres_words(self) -> str:
        """Return the words *along the line of centres* for a collision of discs; empty for other collisions."""
        return (
            " along the line of centres" if self.flights.mechanism.meetings[self.impact.meeting].normal is None else ""
        )

    @property
    def energy_loss(self) -> Expression:
        """Return the energy loss, ½ (1 − e²) times the reduced mass times the squared approach speed."""
        closing = self.flights.closing(self.impact)
        e = self.flights.restitution(self.impact.meeting)
        left = sum_terms(ONE, -Power(e.expression(), 2)) if e else ONE
        half = multiply_factors(Number(0.5), multiply_factors(self.flights.effective_mass(self.impact), left))
        return multiply_factors(half, squared(closing))

    @property
    def impulse_magnitude(self) -> Expression:
        """Return the impulse, (1 + e) times the reduced mass times the approach speed."""
        closing = self.flights.closing(self.impact)
        e = self.flights.restitution(self.impact.meeting).expression()
        size = closing if self.flights.book.value(closing) >= 0.0 else -closing
        return multiply_factors(multiply_factors(sum_terms(ONE, e), self.flights.effective_mass(self.impact)), size)


@dataclass(frozen=True, slots=True)
class FlightPart(MotionPart):
    """One free flight of a body as a part of its motion."""

    flights: Flights
    number: int
    until: Symbol | None  # end time; None: zero duration

    def path(self, body: str) -> Expression:
        """Return the distance covered by a body on a line during the flight."""
        own = [
            k for k in self.flights.coordinates(body) if self.flights.flight_of_body(body, 0).speeds.get(k) is not None
        ]
        if len(own) != 1 or self.flights.acceleration(own[0]):
            raise UnsolvedError("it turns back in flight, or flies in a plane")
        k = own[0]
        begin = self.flights.displacement(body, self.number, k, None)
        end = self.flights.displacement(body, self.number, k, self.until)
        distance = (end - begin).expression()
        return distance if self.flights.book.value(distance) >= 0.0 else -distance


AT_TOP = frozenset({"greatest height", "least speed"})  # functionals extreme at the top
EXTREME_RTOL = 1e-6  # relative: largest difference between the value at the top and the extreme value


def question_at_top(setting: ProblemContext) -> ProblemContext | None:
    """Return the question about the value at the highest point; None if that is not the extreme value asked for."""
    query, study = setting.query, setting.study
    if not isinstance(query, StretchQuery) or query.functional not in AT_TOP:
        return None
    functional, moment = FUNCTIONALS[query.functional], HighestPoint(query.name)
    assert isinstance(functional, Extreme)
    top_query = Query("event", Target(functional.quantity.name, query.name, functional.sense), moment)
    time = study.time(moment)
    if time is None or time > setting.time:
        return None
    value, extreme = KINDS["event"].answer(top_query, study), KINDS[query.kind].answer(query, study)
    if value is None or extreme is None or abs(value - extreme) > EXTREME_RTOL * abs(extreme):
        return None
    return replace(setting, query=top_query)


def write_highest_point(flights: Impacts, body: str) -> None:
    """Write which velocity component is zero at the highest point of a trajectory."""
    falls = [k for k in flights.coordinates(body) if flights.acceleration(k)]
    step, book, leg = (
        flights.book.begin_step("moment"),
        flights.book,
        flights.flight_of_body(body, flights.count(body, None)),
    )
    zero = f"at the highest point of the path the {_velocity(flights, body, falls[0]) if falls else 'velocity'} is zero"
    if falls and leg.after is not None and not book.in_symbols:
        rising = leg.speeds[falls[0]].expression()
        if not book.is_hidden(rising):
            record_inequality(book, step, rising, ZERO)
        zero = f"after {flights.collision(leg.after)}, {flights.setting.display_name(body)} still rises; {zero}"
    step.add_text(f"{capitalized(zero)}.")
    step.close()


def height_at_rest(flights: Impacts, body: str, k: int, *, top: bool) -> Polynomial:
    """Write the displacement of a body along a coordinate at its turning point, without the time: v² = 2 a s."""
    number, a = flights.count(body, None), flights.acceleration(k)
    leg = flights.flight_of_body(body, number)
    before, v = flights.displacement(body, number, k, None), leg.speeds[k].expression()
    step, name = flights.book.begin_step("distance"), flights.book.fresh("s", flights.setting.subscript_of(body))
    double = multiply_factors(Number(2.0), a.expression())
    law = step.law(sum_terms(Power(v, 2), multiply_factors(double, name)), ZERO)
    formula = ratio(-Power(v, 2), double)
    where = "At the highest point of the path" if top else "There"
    zero = f"{where} the {_velocity(flights, body, k)} is zero"
    if leg.after is not None:
        zero = f"{zero}. Let ${name.name}$ be its displacement in this direction since {flights.collision(leg.after)}"
    step.add_text(
        f"{zero}{'; then' if leg.after is not None else ', so'} {law} and {step.result(name, formula, METRES)}."
    )
    step.close()
    return before + Polynomial.from_expression(name)


def _velocity(flights: Impacts, body: str, k: int) -> str:
    """Return words for the velocity of a body along a coordinate, such as *vertical velocity of ball A*."""
    coordinate, who = flights.mechanism.coordinates[k], flights.setting.display_name(body)
    if coordinate.axis[2] > 1.0 - ALIGNMENT_ATOL:
        return f"vertical velocity of {who}"
    plane = len(flights.mechanism.body[body].coordinates) > 1
    return f"velocity of {who} along {coordinate.label}" if plane else f"velocity of {who}"


TIME_RTOL = 1e-9  # relative: a collision this close to the moment counts as simultaneous with it


def write_omitted_collisions(flights: Impacts, bodies: AbstractSet[str]) -> None:
    """Write which earlier collisions the solution omits because they do not affect the given bodies."""
    setting = flights.setting
    early = [impact for impact in flights.impacts if impact.time < setting.time * (1.0 - TIME_RTOL)]
    left = [
        collision
        for collision in early
        if collision.number not in flights.times and collision.number not in flights.velocities_after_impact
    ]
    for impact in left:
        if bodies and bodies.isdisjoint(_affected(impact, early)):
            step = flights.book.begin_step("verify")
            who = setting.bodies_phrase(sorted(bodies))
            step.add_text(
                f"{capitalized(flights.collision(impact))} does not affect {who} before the moment in question."
            )
            step.close()


def _affected(first: Impact, impacts: list[Impact]) -> set[str]:
    """Return the bodies whose motion depends on a collision, also through later collisions."""
    affected = {*first.bodies}
    for impact in impacts:
        if impact.number > first.number and not affected.isdisjoint(impact.bodies):
            affected |= {*impact.bodies}
    return affected
