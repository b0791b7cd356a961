"""Pairs of bodies that do not collide, their relative motion, and the next pair that collides."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from math import inf

from sim2reason.scenes.dsl.mechanism import CollisionPair
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol, ratio
from sim2reason.solutions.algebra.polynomials import NIL
from sim2reason.solutions.collisions.flights import Impact
from sim2reason.solutions.collisions.impacts import Impacts
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.writing.notation import SPEED
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, UnsolvedError, record_inequality


@dataclass(frozen=True)
class Exclusion:
    """One pair of bodies that does not collide, with the kind of argument for this and the number that proves it.

    The number follows from relative position and velocity, which the sentence `motion` states; on a line, the words
    `aside` state them.
    """

    kind: str
    subject: str
    letters: str
    number: str
    limit: str = ""
    motion: str = ""
    aside: str = ""


def clauses(exclusions: Sequence[Exclusion]) -> Iterator[str]:
    """Yield clauses why pairs of bodies do not collide, one clause for all pairs with the same kind of argument."""
    for kind, clause in CLAUSES.items():
        group = [each for each in exclusions if each.kind == kind]
        if group:
            yield clause(group)


def _pairs(exclusions: Sequence[Exclusion]) -> str:
    """Return the subject of a clause, such as *pucks A and B* or *the pairs AB and AC*."""
    return (
        exclusions[0].subject
        if len(exclusions) == 1
        else f"the pairs {join_words([each.letters for each in exclusions])}"
    )


def _numbers(exclusions: Sequence[Exclusion]) -> str:
    """Return a list in words of the numbers, such as times, that prove that pairs do not collide."""
    return join_words([each.number for each in exclusions])


def _meet_later(exclusions: Sequence[Exclusion]) -> str:
    """Return the clause about discs that would touch only after the end of the interval."""
    limit = exclusions[0].limit
    return f"{_pairs(exclusions)} would meet, with their centres ${limit}$ apart, only at {_numbers(exclusions)}"


def _meet_later_in_line(exclusions: Sequence[Exclusion]) -> str:
    """Return the clause about bodies on a line that would meet only after the end of the interval."""
    return join_words([f"{each.subject}, {each.aside}, would meet only at {each.number}" for each in exclusions])


def _reach_later(exclusions: Sequence[Exclusion]) -> str:
    """Return the clause about bodies that would reach a wall only after the end of the interval."""
    return join_words(
        [f"{each.subject}, {each.aside}, would reach {each.limit} only at {each.number}" for each in exclusions]
    )


def _pass(exclusions: Sequence[Exclusion]) -> str:
    """Return the clause about discs whose least distance exceeds the sum of their radii."""
    pairs, numbers, limit = _pairs(exclusions), _numbers(exclusions), exclusions[0].limit
    return f"the centres of {pairs} would be {numbers} apart where closest, more than ${limit}$"


def _part(exclusions: Sequence[Exclusion]) -> str:
    """Return the clause about discs that separate: relative position times relative velocity is positive."""
    verb = "is" if len(exclusions) == 1 else "are"
    return f"{_pairs(exclusions)} move apart, since {_numbers(exclusions)} {verb} positive"


def _part_in_line(exclusions: Sequence[Exclusion]) -> str:
    """Return the clause about bodies on a line that separate."""
    return f"{_pairs(exclusions)} move apart at {_numbers(exclusions)}"


def _slide_off(exclusions: Sequence[Exclusion]) -> str:
    """Return the clause about discs with only tangential relative velocity since an inelastic collision."""
    pairs = _pairs(exclusions)
    return f"{pairs} keep only a relative velocity perpendicular to their line of centres, which takes them apart"


def _go_together(exclusions: Sequence[Exclusion]) -> str:
    """Return the clause about discs without relative velocity after an inelastic head-on collision."""
    return f"{_pairs(exclusions)} move on together at the same velocity"


def _leave_walls(exclusions: Sequence[Exclusion]) -> str:
    """Return the clause about bodies that move away from a wall."""
    return join_words([f"{each.subject} moves away from {each.limit} at {each.number}" for each in exclusions])


CLAUSES: Mapping[str, Callable[[Sequence[Exclusion]], str]] = {
    "later": _meet_later,
    "line later": _meet_later_in_line,
    "wall later": _reach_later,
    "pass": _pass,
    "apart": _part,
    "touching": _slide_off,
    "together": _go_together,
    "line apart": _part_in_line,
    "wall apart": _leave_walls,
}


MAX_FORMULA_LENGTH = 160  # characters of a formula; of a longer one only the value is written


@dataclass(frozen=True)
class RelativeMotion:
    """Numbers of the relative motion of two bodies, named for an argument that the two do not collide."""

    book: SolutionBuilder
    step: StepBuilder
    letters: str
    told: list[str] = field(default_factory=list[str])
    names: list[Expression] = field(default_factory=list[Expression])

    def named(self, base: str, formula: Expression, unit: str, axis: str = "") -> Expression:
        """Name a number of the relative motion that the text states before the argument; zero needs no name."""
        if not self.book.value(formula):
            return ZERO
        self.names.append(self._verified(base, formula, unit, axis, self.told))
        return self.names[-1]

    def quotient(self) -> Expression:
        """Return the first named number divided by the second; UnsolvedError if one of them was zero."""
        if len(self.names) != 2:
            raise UnsolvedError("two that touch collide as soon as they approach each other")
        return ratio(*self.names)

    def concluded(self, base: str, formula: Expression, unit: str) -> str:
        """Write the number that proves that two bodies do not collide, such as a time, and return its equation."""
        equations: list[str] = []
        self._verified(base, formula, unit, "", equations)
        return equations[0]

    def _verified(self, base: str, formula: Expression, unit: str, axis: str, told: list[str]) -> Expression:
        """Define a name for a number, append its equation to `told`, and return the name."""
        name = self.book.fresh(base, f"{axis},{self.letters}" if axis else self.letters)
        self.book.set_value(name.name, self.book.value(formula), self.book.unit_in_text(unit))
        short = len(formula.latex()) <= MAX_FORMULA_LENGTH
        told.append(self.step.verified(name, formula if short else self.book.defer_to_number(formula), unit))
        return name


def approach_sentence(flights: Impacts, step: StepBuilder, begins: Impact, following: Impact) -> str:
    """Return the sentence that two bodies, after one collision, approach the `following` one; empty if obvious."""
    book, meeting = flights.book, flights.mechanism.meetings[following.meeting]
    pair = meeting.normal is not None and len(meeting.names) > 1 and following.meeting != begins.meeting
    if flights.timed or not pair or any(flights.acceleration(k) for b in meeting.names for k in flights.coordinates(b)):
        return ""
    speed = NIL
    for body, (k, sense) in flights.normal_coordinates(meeting).items():
        rate = flights.flight_of_body(body, flights.count(body, following)).speeds[k]
        speed = speed - rate.scale(sense * (1.0 if body == meeting.b else -1.0))
    record_inequality(book, step, speed.expression(), ZERO)
    motion = RelativeMotion(book, step, flights.pair_mark(meeting.names, begins))
    equation = motion.concluded("u", speed.expression(), SPEED)
    who = flights.setting.bodies_phrase(list(meeting.names))
    lead = f"After {flights.collision(begins)}, {who} approach each other at {equation}"
    return f"{lead}; nothing else collides before they do."


def late_values(flights: Impacts, step: StepBuilder) -> Iterator[str]:
    """Yield one sentence with the values of a step's quantities that were unknown before, if there are any."""
    book = flights.book
    used = [name for r in step.relations if r.role == "verified" for name in r.right.symbols()]
    late = [name for name in dict.fromkeys(used) if name in book.formulas and name not in book.stated]
    if late:
        yield f"Now {join_words([step.stated(Symbol(name), book.units[name]) for name in late])}."


def last_collision_sentence(flights: Impacts, step: StepBuilder, last: Impact | None, until: Symbol | None) -> str:
    """Return the sentence that the `last` collision precedes a given time; empty if that is not needed."""
    book, time = flights.book, flights.times.get(last.number) if last is not None else None
    if book.in_symbols or time is None or until is None:
        return ""
    if time.name in book.formulas and until.name in book.stated:
        record_inequality(book, step, until, time)
        which = "last collision" if last is not None and last.number else "collision"
        return f"The {which}, at {step.stated(time, book.units[time.name])}, comes before ${until.latex()}$."
    return ""


TIME_RTOL = 1e-9  # relative: a collision this close to a time counts as simultaneous with it


@dataclass(frozen=True)
class FreeInterval:
    """An interval in which both bodies of a possible collision move freely; `legs` are the numbers of their flights."""

    meeting: int
    legs: dict[str, int]
    begins: Impact | None  # None: at the start
    ends: Impact | None  # None: at the end time

    @property
    def is_collision(self) -> bool:
        """Return whether the two bodies collide at the end of the interval."""
        return self.ends is not None and self.ends.meeting == self.meeting


class Intervals:
    """The intervals of free motion of each pair of bodies, up to a time in s, which may be infinite."""

    def __init__(self, flights: Impacts, time: float) -> None:
        """Take the flights of all bodies and the end time, s."""
        self._flights, self._time = flights, time
        self.early = [impact for impact in flights.impacts if impact.time < time * (1.0 - TIME_RTOL)]

    def __iter__(self) -> Iterator[FreeInterval]:
        """Yield the intervals of each pair of bodies in turn."""
        for number, meeting in enumerate(self._flights.mechanism.meetings):
            changes = [impact for impact in self.early if {*impact.bodies} & {*meeting.names}]
            for begins, ends in zip([None, *changes], [*changes, None], strict=True):
                legs = {body: self._number(body, begins) for body in meeting.names}
                yield FreeInterval(number, legs, begins, ends if ends is not None else self._last(meeting))

    @property
    def at_end(self) -> list[Impact]:
        """Return the collisions at the end time; empty for an infinite time."""
        if self._time == inf:
            return []
        return [impact for impact in self._flights.impacts if abs(impact.time - self._time) <= TIME_RTOL * self._time]

    def next_collision(self, begins: Impact | None) -> Impact | None:
        """Return the first collision after a given one, up to the end time, or the first of all for None."""
        number = 0 if begins is None else begins.number + 1
        return next((impact for impact in (*self.early, *self.at_end) if impact.number >= number), None)

    def is_late(self, held: FreeInterval) -> bool:
        """Return whether the two bodies of an interval collide at its end, but others collide before."""
        return held.is_collision and held.ends is not self.next_collision(held.begins)

    def _last(self, meeting: CollisionPair) -> Impact | None:
        """Return the collision at the end time in which a body of the given pair takes part; None if there is none."""
        return next((impact for impact in self.at_end if {*impact.bodies} & {*meeting.names}), None)

    def _number(self, body: str, begins: Impact | None) -> int:
        """Return the number of the flight of a body that follows a collision; 0 for the flight from the start."""
        if begins is None:
            return 0
        return self._flights.count(body, begins) + (body in begins.bodies)
