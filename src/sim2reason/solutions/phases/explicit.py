"""Accelerations and forces that a few linear laws determine, as formulas of known numbers."""

from collections.abc import Collection, Mapping, Sequence

from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import ZERO, Expression, added
from sim2reason.solutions.algebra.inverse import solved_for, substitute
from sim2reason.solutions.closed_forms import ClosedFormError, simplified_form
from sim2reason.solutions.solution import Relation

MAX_SOLVED_LAWS = 4  # largest number of laws that are solved by formulas
MAX_FORMULA_LENGTH = 80  # maximum length of the LaTeX of a formula that is written beside its number


def explicit_formulas(
    laws: Sequence[Relation], names: Collection[str], values: Mapping[str, float]
) -> dict[str, Expression]:
    """Return the short formulas, by name, of the unknowns that laws determine; empty for many laws.

    `values` holds the values of all names.
    """
    chain: list[tuple[str, Expression]] = []
    waiting = [added(law.left, -law.right) for law in laws] if len(laws) <= MAX_SOLVED_LAWS else []
    while waiting:
        unknown = [[name for name in names if name in held.symbols()] for held in waiting]
        place = min(range(len(waiting)), key=lambda n: len(unknown[n]) or len(names) + 1)
        if not unknown[place]:
            break
        law, name = waiting.pop(place), unknown[place][-1]
        formula = solved_for(name, law, ZERO, values)
        if isinstance(formula, NumericRoot):
            return {}
        waiting = [substitute(held, name, formula) for held in waiting]
        chain.append((name, formula))
    found: dict[str, Expression] = {}
    for name, formula in reversed(chain):
        for other, known in found.items():
            formula = substitute(formula, other, known)  # noqa: PLW2901
        found[name] = formula
    short = {name: _short(held) for name, held in found.items() if {*names}.isdisjoint(held.symbols())}
    return {name: held for name, held in short.items() if held is not None and len(held.latex()) <= MAX_FORMULA_LENGTH}


def _short(formula: Expression) -> Expression | None:
    try:
        return simplified_form(formula).expression
    except ClosedFormError:
        return None
