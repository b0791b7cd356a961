"""The angular frequency of the normal mode that a question is about, and which of the modes that is."""

from sim2reason.questions.period_words import SPEEDS, PeriodQuery
from sim2reason.solutions.algebra.expressions import Symbol
from sim2reason.solutions.algebra.functions import Power, Root
from sim2reason.solutions.oscillations.mode import Mode
from sim2reason.solutions.oscillations.mode_laws import PAIR, ModeLaws
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import UnsolvedError
from sim2reason.solutions.writing.unit_latex import ANGULAR_SPEED, PER_SECOND_SQUARED

SMALLER = {"slower": "smaller", "faster": "greater", "slowest": "smallest", "fastest": "greatest"}


def natural_frequency(held: ModeLaws, query: PeriodQuery) -> Symbol:
    """Write the angular frequency that a question asks about; UnsolvedError where the motion has no period."""
    if not query.small and held.size - held.zeros > 1:
        raise UnsolvedError("the motion as a whole has no period")
    mode = held.modes[held.zeros + (query.rank if query.small else 0)]
    said = "The angular frequency is"
    if query.small and query.modes > 1:
        which = SPEEDS[query.modes][query.rank > 0]
        said = f"As each root is the square of an angular frequency, the {which} mode has the {SMALLER[which]} one:"
        if held.size - held.zeros == PAIR and held.book.is_hidden(mode.square) and not held.book.in_symbols:
            held.book.afterwards.append(lambda: _tell_other_root(held, mode, query))
    name = held.book.fresh(r"\omega")
    return held.book.told("rate", said, name, Root(mode.square), ANGULAR_SPEED)


def _tell_other_root(held: ModeLaws, mode: Mode, query: PeriodQuery) -> None:
    """Write the root of the other mode, once all numbers are known, from the product of both."""
    book, slower, square = held.book, query.rank == 0, mode.square
    rest, _, leading = held.powers[held.zeros :]
    formula = rest.expression() / (leading.expression() * square)
    step, name = book.open("verify"), book.fresh(r"\lambda", r"\text{other}")
    exceeds(book, step, *((formula, square) if slower else (square, formula)))
    product = (
        f"The product of both roots is the constant term divided by the coefficient of ${Power(square, 2).latex()}$"
    )
    step.say(f"{product}, so the other root is {step.verified(name, formula, PER_SECOND_SQUARED)}.")
    size, which = ("greater", "slower") if slower else ("smaller", "faster")
    step.say(f"It is {size}, so the given {query.measure} is that of the {which} mode.")
    step.close()
