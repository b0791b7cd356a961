"""Answers that a formula leads to, so that engines need only say whether they hold."""

from collections.abc import Callable
from contextlib import suppress

from sim2reason.prose.formula_numbers import factor
from sim2reason.questions import KINDS, Query, Study, Words
from sim2reason.solutions.closed_forms import ClosedFormError, put_together
from sim2reason.solutions.derivation import derivation


def likely_answers(query: Query, study: Study, words: Words, path: str) -> Callable[[float], float] | None:
    """The answer to a query about a limit by the value of the number at an address, as the formula for it says.

    0 where it has no value. None of other queries, and where none is derived.
    """
    if not query.hides or path not in words.symbols:
        return None
    solution = derivation(query, study, words)
    try:
        whole = put_together(solution) if solution.derived else None
    except ClosedFormError:
        return None
    if whole is None:
        return None
    symbol = words.symbols[path]
    given = factor(next(p.measure.unit for p in study.scene.parameters if p.path == path))
    wanted = factor(KINDS[query.kind].measured(query).unit)

    def answer(value: float) -> float:
        with suppress(ValueError, ArithmeticError):
            return whole.value({**solution.values, symbol: given * value}).real / wanted
        return 0.0

    return answer
