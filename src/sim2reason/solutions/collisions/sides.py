"""On which side of its start a body on a line is first so far from there, after a collision."""

from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.collisions.oblique import Flights
from sim2reason.solutions.writing.comparing import exceeds


def tell_side(flights: Flights, body: str, k: int, distance: Symbol) -> None:
    """Write that a body is less than a distance from its start until its last flight, and where it then moves.

    Where numbers are unknown, it is written in the end; in symbols the problem assumes it.
    """
    book, number = flights.book, flights.count(body, None)
    ends = [flights.place(body, n, k, None).expression() for n in range(1, number + 1)]
    speed = flights.leg(body, number).speeds[k].expression()
    if book.in_symbols:
        return
    if any(map(book.is_hidden, (*ends, speed, distance))):
        book.afterwards.append(lambda: _tell(flights, body, k, distance, (ends, speed)))
    else:
        _tell(flights, body, k, distance, (ends, speed))


def _tell(flights: Flights, body: str, k: int, distance: Symbol, motion: tuple[list[Expression], Expression]) -> None:
    book, (ends, speed), leg = flights.book, motion, flights.leg(body, flights.count(body, None))
    assert leg.after is not None
    sizes = [-end if book.value(end) < 0.0 else end for end in ends if end != ZERO]
    farthest = max(sizes, key=book.value, default=ZERO)
    step, who, forward = book.open("verify"), flights.setting.called(body), book.value(speed) > 0.0
    if farthest != ZERO:
        exceeds(book, step, distance, farthest)
    exceeds(book, step, *((speed, ZERO) if forward else (ZERO, speed)))
    x, y, z = flights.mechanism.coordinates[k].axis
    towards = flights.setting.towards((x, y, z) if forward else (-x, -y, -z))
    step.say(f"Until {flights.collision(leg.after)}, {who} is never as far as ${distance.latex()}$ from its start;")
    alone = len(flights.mechanism.meetings) == 1 and flights.restitution(leg.after.meeting)
    parted = " The two do not meet again, as they move apart." if alone else ""
    step.say(f"then it moves {towards}.{parted}")
    step.close()
