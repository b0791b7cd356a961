"""Expected answers from a formula, which engines then only need to confirm."""

from collections.abc import Callable, Mapping
from contextlib import suppress

from sim2reason.questions import KINDS, Query, SimulatedScene, Words
from sim2reason.solutions.algebra.expressions import Expression
from sim2reason.solutions.closed_forms import ClosedFormError, combined_formula
from sim2reason.solutions.derivation import derivation
from sim2reason.text.prose.description import factor


def likely_answers(query: Query, study: SimulatedScene, words: Words, path: str) -> Callable[[float], float] | None:
    """Return the likely answer as a function of the number at an address, for a question about its limit.

    The function returns 0 where the formula has no value. None for other queries, and if no formula is derived.
    """
    if not query.hides or path not in words.symbols:
        return None
    solution = derivation(query, study, words)
    try:
        whole = combined_formula(solution) if solution.derived else None
    except ClosedFormError:
        return None
    if whole is None:
        return None
    symbol, formula = words.symbols[path], whole
    given = factor(next(p.measure.unit for p in study.scene.parameters if p.path == path))
    wanted = factor(KINDS[query.kind].measured(query).unit)

    return lambda value: likely_answer(formula, {**solution.values, symbol: given * value}, wanted)


def likely_answer(formula: Expression, at: Mapping[str, float], factor: float) -> float:
    """Return the value of a formula in the answer's unit (`factor`); 0 if undefined."""
    with suppress(ValueError, ArithmeticError):
        return formula.value(at).real / factor
    return 0.0
