"""Accelerations and forces that a few linear laws give, as formulas of what is known before."""

from collections.abc import Collection, Mapping, Sequence

from sim2reason.solutions.algebra.evaluated import NumericRoot
from sim2reason.solutions.algebra.expressions import ZERO, Expression, added
from sim2reason.solutions.algebra.inverse import put, solved_for
from sim2reason.solutions.closed_forms import ClosedFormError, shortened
from sim2reason.solutions.solution import Relation

FEW = 4  # laws that are solved by formulas
LONG = 80  # characters of a formula that is told beside its number


def explicit(laws: Sequence[Relation], names: Collection[str], values: Mapping[str, float]) -> dict[str, Expression]:
    """Return the short ones among the formulas of names that laws determine; none for many laws.

    `values` has the values of all names.
    """
    chain: list[tuple[str, Expression]] = []
    waiting = [added(law.left, -law.right) for law in laws] if len(laws) <= FEW else []
    while waiting:
        unknown = [[name for name in names if name in held.symbols()] for held in waiting]
        place = min(range(len(waiting)), key=lambda n: len(unknown[n]) or len(names) + 1)
        if not unknown[place]:
            break
        law, name = waiting.pop(place), unknown[place][-1]
        formula = solved_for(name, law, ZERO, values)
        if isinstance(formula, NumericRoot):
            return {}
        waiting = [put(held, name, formula) for held in waiting]
        chain.append((name, formula))
    found: dict[str, Expression] = {}
    for name, formula in reversed(chain):
        for other, known in found.items():
            formula = put(formula, other, known)  # noqa: PLW2901
        found[name] = formula
    short = {name: _short(held) for name, held in found.items() if {*names}.isdisjoint(held.symbols())}
    return {name: held for name, held in short.items() if held is not None and len(held.latex()) <= LONG}


def _short(formula: Expression) -> Expression | None:
    try:
        return shortened(formula).expression
    except ClosedFormError:
        return None
