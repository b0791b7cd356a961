"""Numerical proofs that a body has turned back, or a stage has ended, before an instant or distance, or has not."""

from collections.abc import Callable

from sim2reason.solutions.algebra.expressions import ZERO, Expression, Quotient, Symbol, added, multiplied
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.writing.comparing import record_inequality
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder
from sim2reason.solutions.writing.unit_latex import METRES, SECONDS, SPEED


def turned_before(book: SolutionBuilder, step: StepBuilder, begun: Expression, a: Symbol, time: Symbol) -> str:
    """Return words such as *, before t*, added to a sentence about a velocity that becomes zero before a time."""
    formula = Quotient(-begun, a)
    record_inequality(book, step, time, formula)
    if book.is_hidden(formula):
        return f", before ${time.name}$"
    name = book.fresh("t", r"\text{turn}")
    return f", after {step.verified(name, formula, SECONDS)}, which is less than ${time.name}$"


def later_words(book: SolutionBuilder, step: StepBuilder, formula: Expression, time: Symbol) -> str:
    """Return *only after t_turn = ..., which is more than t*, for a time in s, and record the comparison."""
    record_inequality(book, step, formula, time)
    told = step.verified(book.fresh("t", r"\text{turn}"), formula, SECONDS)
    return f"only after {told}, which is more than ${time.name}$"


def tell_turning_only_later(book: SolutionBuilder, begun: Expression, a: Symbol, time: Symbol | None) -> None:
    """Write that a decreasing velocity becomes zero only after a time, if the time is known."""
    formula = Quotient(-begun, a)
    if time is None or book.is_hidden(formula) or book.is_hidden(time) or not book.value(formula) > 0.0:
        return
    step = book.begin_step("verify")
    step.add_text(f"It would turn back {later_words(book, step, formula, time)}, so this is the distance.")
    step.close()


def tell_not_turned(book: SolutionBuilder, begun: Expression, a: Symbol, time: Symbol, who: str) -> None:
    """Write that a body is at a place for the first time at a given time, as its velocity is still positive."""
    if book.in_symbols:
        return
    formula = added(begun, multiplied(a, time))
    step, name = book.begin_step("verify"), book.fresh("v")
    record_inequality(book, step, formula, ZERO)
    told = step.verified(name, formula, SPEED)
    step.add_text(f"At ${time.name}$ the velocity is {told} and still positive, so {who} is there for the first time.")
    step.close()


def verify_remaining(book: SolutionBuilder, left: Symbol, formula: Expression, until: str) -> None:
    """Schedule a check for the end of the text that earlier stages end before an instant; none for known numbers."""

    def write() -> None:
        step = book.begin_step("verify")
        record_inequality(book, step, left, ZERO)
        told = step.verified(left, formula, SECONDS)
        step.add_text(f"Indeed {told} is positive, so the earlier motion ends before ${until}$.")
        step.close()

    _in_the_end(book, left, write)


def verify_farther(book: SolutionBuilder, whole: Polynomial, covers: tuple[Symbol, Polynomial], who: str) -> None:
    """Write, or schedule for the end of the text, that the earlier stages do not cover a whole distance.

    `whole` is the remaining distance; `covers` has the distance and the displacement so far.
    """
    rest, (distance, place) = whole.expression(), covers

    def write() -> None:
        step, name = book.begin_step("verify"), book.fresh("s", r"\text{rest}")
        left = book.magnitude(rest)
        record_inequality(book, step, left, ZERO)
        step.add_text(
            f"Indeed {step.verified(name, left, METRES)} is positive, so the distance is covered only after this."
        )
        step.close()

    _in_the_end(book, rest, write)
    covered = place.expression() if book.value(place.expression()) > 0.0 else place.scaled(-1.0).expression()
    if place and not book.in_symbols and not book.is_hidden(rest):
        step = book.begin_step("verify")
        record_inequality(book, step, distance, covered)
        step.add_text(
            f"As ${covered.latex()} < {distance.latex()}$, {who} covers the distance ${distance.latex()}$ only later."
        )
        step.close()


def _in_the_end(book: SolutionBuilder, held: Expression, write: Callable[[], None]) -> None:
    """Schedule a check for the end of the text if the quantity checked depends on the question's unknown."""
    if book.is_hidden(held) and not book.in_symbols:
        book.afterwards.append(write)
