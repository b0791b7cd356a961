"""The order of collisions: why no other pair meets before the next one, and none after the last one."""

from collections.abc import Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from math import inf

from sim2reason.dsl.mechanism import Meeting
from sim2reason.dsl.triples import minus, product
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Number, Symbol, added, multiplied, ratio
from sim2reason.solutions.algebra.functions import Absolute, Power, Root, summed
from sim2reason.solutions.algebra.polynomials import NIL, Polynomial
from sim2reason.solutions.collisions.exclusions import Excluded, clauses
from sim2reason.solutions.collisions.flights import Impact
from sim2reason.solutions.collisions.impacts import Impacts
from sim2reason.solutions.solution import Step
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.lexicon import Both
from sim2reason.solutions.writing.steps import Writing
from sim2reason.solutions.writing.unit_latex import METRES, SECONDS, SPEED, latex

ORDER = "order of collisions"  # the kind of these steps
STILL = 1e-12  # m/s or m²/s: no relative motion


@dataclass(frozen=True)
class Together:
    """An interval in which both bodies of a possible collision move freely; `legs` are their flights, by body."""

    meeting: int
    legs: dict[str, int]
    begins: Impact | None  # None: at the start
    ends: Impact | None  # None: when the motion that counts ends


class CollisionOrder:
    """A writer of the reasons why no other pair collides before the next collision, up to a given time."""

    def __init__(self, flights: Impacts, time: float) -> None:
        """Take all flights; the motion counts until `time`, s, which may be infinite."""
        self._flights, self._book, self._time = flights, flights.book, time
        self._until: Symbol | None = None
        self._first = len(self._book.steps)  # the number of the first step about these flights
        self._early = [impact for impact in flights.impacts if impact.time < time * (1.0 - 1e-9)]

    def follow(self) -> None:
        """Write all collisions before the end in the order of time."""
        for impact in self._early:
            self._flights.when(impact)
            self._flights.after(impact)

    def tell(self, until: Symbol | None) -> None:
        """Write a sentence for the start and for each collision after which it is not obvious who meets next.

        `until` names the time until which the motion counts; None if it never ends.
        """
        self._until = until
        for begins in (None, *self._early):
            step, told = self._book.open(ORDER), list[Excluded]()
            for stretch in self._stretches():
                found = self._excluded(step, stretch) if stretch.begins == begins else None
                told += [found] if found is not None else []
            if told:
                step.say(f"{self._lead(begins)} {'; '.join(clauses(told))}{self._hence(begins)}.")
                step.close()
                self._book.earliest[self._book.steps[-1].id] = self._first

    # ---- which flights overlap

    def _stretches(self) -> Iterator[Together]:
        flights = self._flights
        for number, meeting in enumerate(flights.mechanism.meetings):
            changes = [held for held in self._early if {*held.bodies} & {*meeting.names}]
            for begins, ends in zip([None, *changes], [*changes, None], strict=True):
                legs = {body: self._number(body, begins) for body in meeting.names}
                yield Together(number, legs, begins, ends if ends is not None else self._last(meeting))

    def _last(self, meeting: Meeting) -> Impact | None:
        """Return the collision with which the motion that counts ends, if it is one of the partners."""
        found = (held for held in self._flights.impacts if abs(held.time - self._time) <= 1e-9 * self._time)
        return next((held for held in found if {*held.bodies} & {*meeting.names}), None)

    def _number(self, body: str, begins: Impact | None) -> int:
        if begins is None:
            return 0
        return self._flights.count(body, begins) + (body in begins.bodies)

    # ---- why two do not meet

    def _excluded(self, step: Writing, held: Together) -> Excluded | None:
        """Return why partners do not meet while they fly freely; None if that is obvious, or if they do meet."""
        meets = held.ends is not None and held.ends.meeting == held.meeting
        meeting = self._flights.mechanism.meetings[held.meeting]
        just_met = held.begins is not None and held.begins.meeting == held.meeting
        if meets or any((body, leg) in self._flights.flown for body, leg in held.legs.items()):
            return None
        if meeting.normal is None:
            return None if just_met else self._aside(step, held, meeting)
        return self._in_line(step, held, just_met=just_met)

    def _aside(self, step: Writing, held: Together, meeting: Meeting) -> Excluded | None:
        """Return why two discs do not collide in an interval."""
        book, d = self._book, self._flights.setting.lexicon.of(lambda m: m.meetings[held.meeting].distance).expression()
        X, u = zip(*self._relative(held, meeting), strict=True)
        mark, who = self._names(held)
        along = [multiplied(book.worked(x), book.worked(w)) for x, w in zip(X, u, strict=True)]
        speed, q = summed(Power(book.worked(w), 2) for w in u), summed(along)
        if max(abs(book.value(w)) for w in u) < STILL:
            return None
        if book.value(q) >= 0.0:
            name = book.fresh("q", mark)
            exceeds(book, step, q, ZERO)
            return Excluded("apart", who, mark, self._verified(step, name, q, latex("m^2/s")))
        aside: Expression = ZERO
        if len(X) > 1:
            aside = added(
                multiplied(book.worked(X[0]), book.worked(u[1])), -multiplied(book.worked(X[1]), book.worked(u[0]))
            )
        if abs(book.value(aside)) >= book.value(Root(speed)) * book.value(d):
            name, apart = book.fresh("b", mark), ratio(Absolute(aside), Root(speed))
            exceeds(book, step, apart, d)
            return Excluded("pass", who, mark, self._verified(step, name, apart, METRES), d.latex())
        p, q, c = (book.worked(each) for each in (speed, q, aside))
        square = added(multiplied(p, Power(d, 2)), -Power(c, 2))
        return self._later(step, held, ratio(added(-q, -Root(square)), p))

    def _in_line(self, step: Writing, held: Together, *, just_met: bool) -> Excluded | None:
        """Return why two bodies on a line, or a body and a wall, do not collide in an interval."""
        flights, book = self._flights, self._book
        ways, meeting = flights.ways(flights.mechanism.meetings[held.meeting]), flights.mechanism.meetings[held.meeting]
        begin, gap, rate, rise = self._begin(held), flights.gap(held.meeting), NIL, NIL
        for body, (k, sense) in ways.items():
            sign = sense * (1.0 if body == meeting.b else -1.0)
            place, velocity = self._drift(body, held.legs[body], k, begin)
            a = flights.acceleration(k).scaled(sign)
            gap, rate, rise = gap + place.scaled(sign), rate + velocity.scaled(sign), rise + a
        rate, gap = rate + rise * begin, gap + (rise * begin * begin).scaled(0.5)
        mark, who = self._names(held)
        if rise:
            return self._thrown(step, held, (NIL if just_met else gap, rate, rise))
        speed = book.worked(rate.expression())
        if just_met or abs(book.value(speed)) < STILL:
            return None
        if book.value(speed) > 0.0:
            exceeds(book, step, speed, ZERO)
            said = self._verified(step, book.fresh("u", mark), rate.expression(), SPEED)
            return Excluded("wall apart" if len(ways) == 1 else "line apart", who, mark, said)
        return self._later(step, held, ratio(book.worked(gap.expression()), -speed))

    def _thrown(
        self, step: Writing, held: Together, motion: tuple[Polynomial, Polynomial, Polynomial]
    ) -> Excluded | None:
        """Return why a body that accelerates relative to a wall does not reach it; None if it never could."""
        book = self._book
        gap, rate, rise = (Polynomial.of(book.worked(part.expression())) if part else NIL for part in motion)
        if not gap:
            return self._later(step, held, ratio(rate.scaled(-2.0).expression(), rise.expression()))
        double = multiplied(Number(2.0), multiplied(rise.expression(), gap.expression()))
        square = Power(rate.expression(), 2)
        if book.value(rise.expression()) > 0.0 and (
            book.value(rate.expression()) >= 0.0 or book.value(square) < book.value(double)
        ):
            return None
        return self._later(step, held, self._flights.root(gap, rate, rise))

    def _later(self, step: Writing, held: Together, span: Expression) -> Excluded:
        """Return the argument that two bodies would collide only after the end of an interval."""
        book, flights = self._book, self._flights
        mark, who = self._names(held)
        end = flights.when(held.ends) if held.ends is not None else self._until
        assert end is not None
        exceeds(book, step, added(self._begin(held).expression(), span), self._since_start(end).expression())
        said = self._verified(step, book.fresh("t", mark), span, SECONDS)
        return Excluded("wall later" if len(held.legs) == 1 else "later", who, mark, said)

    def _verified(self, step: Writing, name: Symbol, formula: Expression, unit: str) -> str:
        self._book.observed[name.name] = self._book.value(formula)
        return step.verified(name, formula, unit)

    # ---- the motion without what gravity adds to all of it

    def _relative(self, held: Together, meeting: Meeting) -> Iterator[tuple[Expression, Expression]]:
        """Yield position and velocity of the second body relative to the first, by coordinate, at the beginning."""
        flights, begin = self._flights, self._begin(held)
        one, other = meeting.names
        places = [minus(f.center(other).place, f.center(one).place) for f in flights.frames]
        lexicon = flights.setting.lexicon
        for i, j in zip(flights.coordinates(one), flights.coordinates(other), strict=True):
            axes = lexicon.mechanism.coordinates[i].axis, lexicon.twin.coordinates[i].axis
            along = [float(product(apart, axis)) for apart, axis in zip(places, axes, strict=True)]
            (s, v), (r, w) = (self._drift(b, held.legs[b], k, begin) for b, k in ((one, i), (other, j)))
            yield (lexicon.read(Both(*along)) + r - s).expression(), (w - v).expression()

    def _drift(self, body: str, number: int, k: int, time: Polynomial) -> tuple[Polynomial, Polynomial]:
        """Return displacement and velocity at a time of a flight without the common terms ½ a t² and a t."""
        flights, a = self._flights, self._flights.acceleration(k)
        place, before, velocity = NIL, NIL, NIL
        for n in range(number + 1):
            leg = flights.leg(body, n)
            begins = self._since_start(flights.begins(leg))
            place = place + velocity * (begins - before)
            velocity, before = leg.speeds[k] - a * begins, begins
        return place + velocity * (time - before), velocity

    def _begin(self, held: Together) -> Polynomial:
        return self._since_start(None if held.begins is None else self._flights.when(held.begins))

    def _since_start(self, time: Symbol | None) -> Polynomial:
        """Return a time as a sum of those that the text has, counted from the start."""
        if time is None:
            return NIL
        if time in self._flights.sums:
            begins, span = self._flights.sums[time]
            return self._since_start(begins) + Polynomial.of(span)
        return Polynomial.of(time)

    # ---- words

    def _names(self, held: Together) -> tuple[str, str]:
        setting = self._flights.setting
        return "".join(map(setting.mark, held.legs)), setting.listed(list(held.legs))

    def _lead(self, begins: Impact | None) -> str:
        if begins is None:
            return "Undisturbed,"
        return f"After {self._flights.event(self._flights.when(begins))},"

    def _hence(self, begins: Impact | None) -> str:
        """Return what follows about the next collision, where these are the last ones to be excluded."""
        following = self._flights.impacts[0] if begins is None and self._flights.impacts else None
        if following is not None and (self._time == inf or following.time <= self._time * (1.0 + 1e-9)):
            return f", so {self._meet(following)} first"
        if begins is not None and begins != self._early[-1]:
            return ""
        if self._until is None:
            return ", so there is no further collision"
        return "" if self._last_of_all() else f", so there is no further collision before ${self._until.latex()}$"

    def _meet(self, impact: Impact) -> str:
        met = self._flights.met(impact)
        return met[:1].lower() + met[1:]

    def _last_of_all(self) -> bool:
        """Return whether the question is about the instant of a collision."""
        return any(abs(held.time - self._time) <= 1e-9 * self._time for held in self._flights.impacts)


def in_order(steps: Sequence[Step], earliest: Mapping[int, int], late: AbstractSet[str]) -> list[Step]:
    """Put each argument after the last step from which its numbers follow, and after the time of the first collision.

    That is the first one among the steps from a number on, which `earliest` has by the number of the argument.
    An argument with one of the names that are known only `late`, at the end, stays where it is.
    """
    found = [step for step in steps if step.kind != ORDER or not late.isdisjoint(step.symbols())]
    for step in steps:
        if step in found:
            continue
        used = {name for r in step.relations if r.role == "verified" for name in r.right.symbols()}
        after = [n for n, held in enumerate(found) if used & {*held.gives}]
        begins = earliest[step.id]
        times = (n for n, held in enumerate(found) if held.kind == "impact time" and held.id >= begins)
        first = next(times, next((n - 1 for n, held in enumerate(found) if held.id >= begins), len(found) - 1))
        found.insert(max([first, *after]) + 1, step)
    return found
