"""Whether a body that is slowed down has turned back by an instant, shown in numbers."""

from sim2reason.solutions.algebra.expressions import ZERO, Expression, Quotient, Symbol, added, multiplied
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import Book, Writing
from sim2reason.solutions.writing.unit_latex import SECONDS, SPEED


def turned_before(book: Book, step: Writing, begun: Expression, a: Symbol, time: Symbol) -> str:
    """Return that a velocity that begins as `begun` has become zero before a time, as an addition to a sentence."""
    formula = Quotient(-begun, a)
    exceeds(book, step, time, formula)
    if book.is_hidden(formula):
        return f", before ${time.name}$"
    name = book.fresh("t", r"\text{turn}")
    book.observed[name.name] = book.value(formula)
    return f", after {step.verified(name, formula, SECONDS)}, which is less than ${time.name}$"


def tell_not_turned(book: Book, begun: Expression, a: Symbol, time: Symbol, who: str) -> None:
    """Write that a body still moves on at a time, so that it is there for the first time."""
    if book.in_symbols:
        return
    formula = added(begun, multiplied(a, time))
    step, name = book.open("verify"), book.fresh("v")
    exceeds(book, step, formula, ZERO)
    book.observed[name.name] = book.value(formula)
    told = step.verified(name, formula, SPEED)
    step.say(f"At ${time.name}$ the velocity is {told} and still positive, so {who} is there for the first time.")
    step.close()
