"""The final step of questions about a period, from the angular frequency."""

from sim2reason.questions.phrasing import PeriodQuery
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import PI
from sim2reason.solutions.writing.steps import SolutionBuilder
from sim2reason.solutions.writing.unit_latex import ANGULAR_SPEED, SECONDS, latex

TWO = Number(2.0)


def measured_period(book: SolutionBuilder, query: PeriodQuery, rate: Expression, said: str = "The period is") -> Symbol:
    """Write the period, frequency or angular frequency asked for, from ω in rad/s, and return the answer's symbol."""
    if query.measure == "angular frequency" and isinstance(rate, Symbol):
        return rate
    if query.measure == "angular frequency":
        return book.add_step("period", "The angular frequency is", book.fresh(r"\omega"), rate, ANGULAR_SPEED)
    if query.measure == "frequency":
        return book.add_step("period", "The frequency is", book.fresh("f"), rate / (TWO * PI), latex("Hz"))
    return book.add_step("period", said, book.fresh("T"), TWO * PI / rate, SECONDS)
