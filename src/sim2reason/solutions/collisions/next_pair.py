"""The reason why two bodies on a line collide next, if no time of their collision is written; numbers known late."""

from collections.abc import Iterator

from sim2reason.solutions.algebra.expressions import ZERO, Symbol
from sim2reason.solutions.algebra.polynomials import NIL
from sim2reason.solutions.collisions.impacts import Impacts
from sim2reason.solutions.collisions.legs import Impact
from sim2reason.solutions.collisions.relative import RelativeMotion
from sim2reason.solutions.setting import joined
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import Writing
from sim2reason.solutions.writing.unit_latex import SPEED


def told_approach(flights: Impacts, step: Writing, begins: Impact, following: Impact) -> str:
    """Return the sentence that the bodies of the `following` collision approach each other; empty if that is told."""
    book, meeting = flights.book, flights.mechanism.meetings[following.meeting]
    pair = meeting.normal is not None and len(meeting.names) > 1 and following.meeting != begins.meeting
    if flights.timed or not pair or any(flights.acceleration(k) for b in meeting.names for k in flights.coordinates(b)):
        return ""
    speed = NIL
    for body, (k, sense) in flights.ways(meeting).items():
        rate = flights.leg(body, flights.count(body, following)).speeds[k]
        speed = speed - rate.scaled(sense * (1.0 if body == meeting.b else -1.0))
    exceeds(book, step, speed.expression(), ZERO)
    motion = RelativeMotion(book, step, flights.pair_mark(meeting.names, begins))
    said = motion.concluded("u", speed.expression(), SPEED)
    who = flights.setting.listed(list(meeting.names))
    lead = f"After {flights.collision(begins)}, {who} approach each other at {said}"
    return f"{lead}; nothing else collides before they do."


def late_values(flights: Impacts, step: Writing) -> Iterator[str]:
    """Yield a sentence with the values of an argument that were unknown before."""
    book = flights.book
    used = [name for r in step.relations if r.role == "verified" for name in r.right.symbols()]
    late = [name for name in dict.fromkeys(used) if name in book.formulas and name not in book.stated]
    if late:
        yield f"Now {joined([step.stated(Symbol(name), book.units[name]) for name in late])}."


def told_before(flights: Impacts, step: Writing, last: Impact | None, until: Symbol | None) -> str:
    """Return the sentence that the `last` collision comes before a given time; empty if nothing needs to say so."""
    book, time = flights.book, flights.times.get(last.number) if last is not None else None
    if book.in_symbols or time is None or until is None:
        return ""
    if time.name in book.formulas and until.name in book.stated:
        exceeds(book, step, until, time)
        which = "last collision" if last is not None and last.number else "collision"
        return f"The {which}, at {step.stated(time, book.units[time.name])}, comes before ${until.latex()}$."
    return ""
