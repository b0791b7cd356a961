"""By how much the velocity of a bob on a string that goes slack has changed since the start."""

from sim2reason.solutions.algebra.expressions import ZERO, Expression
from sim2reason.solutions.algebra.functions import Root, squares
from sim2reason.solutions.setting import joined
from sim2reason.solutions.swings.slack_chain import Instant
from sim2reason.solutions.writing.steps import Book


def size_of(one: Expression, other: Expression) -> Expression:
    """Return the size of a vector by its components, of either sign where only one is not zero."""
    return one + other if ZERO in (one, other) else Root(squares([one, other]))


def change(book: Book, there: Instant, start: Instant) -> Expression:
    """Return the magnitude of the change of velocity, from differences that are not negative."""
    pairs = ((there.vx, start.vx), (there.vy, start.vy))
    return size_of(*(one - two if book.value(one - two) >= 0.0 else two - one for one, two in pairs))


def tell_velocities(book: Book, there: Instant, start: Instant, *, flies: bool) -> None:
    """Write between which velocities the momentum changes."""
    step = book.open("extreme")
    first = [f"${v.latex()}$ along {axis}" for v, axis in ((start.vx, "x"), (start.vy, "y")) if v != ZERO]
    step.say(f"The initial velocity is {joined(first)}." if first else "")
    step.close()
    if flies:
        tell_flight(book, there)


def tell_flight(book: Book, there: Instant) -> None:
    """Write that the horizontal velocity is constant in free flight, and the vertical one zero at the highest point."""
    step = book.open("extreme")
    at = ", and the vertical one is zero at the highest point" if there.vy == ZERO else ""
    step.say(f"In free flight the horizontal velocity stays ${there.vx.latex()}${at}.")
    step.close()
