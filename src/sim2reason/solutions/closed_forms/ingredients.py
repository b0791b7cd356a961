"""The last algebra of an answer in symbols: what its formula is made of, in terms of what is given."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from sim2reason.solutions.algebra.expressions import Expression, Quotient, Sum, Symbol
from sim2reason.solutions.closed_forms.closed_form import ClosedFormError, Substitution, definitions, shortened
from sim2reason.solutions.setting import joined
from sim2reason.solutions.solution import Relation, Solution, Step

MOST, LONG = 4, 120  # quantities that are told; characters of a formula that no longer helps


def with_ingredients(solution: Solution) -> Solution:
    """Return a solution in symbols with a last step that says what the quantities in the answer's formula come to.

    Those that are given, that one formula gives in terms of what is given, or that the text has, are not repeated.
    """
    formulas = definitions(solution)
    given = {relation.left.latex() for relation in solution.relations if relation.role == "given"}
    given -= solution.constants.keys()
    said = " ".join(step.text for step in solution.steps)
    relations = [held for held in _told(solution.goal, formulas, given) if held.latex() not in said][:MOST]
    if not relations:
        return solution
    used = {relation.left.latex() for relation in relations}
    text = f"In terms of the given quantities, {joined([relation.latex() for relation in relations])}."
    needs = tuple(step.id for step in solution.steps if used.intersection(step.gives))
    step = Step(len(solution.steps), "ingredients", text, tuple(relations), (), needs, solution.steps[-1].phase)
    return replace(solution, steps=(*solution.steps, step))


def _told(goal: str, formulas: Mapping[str, Expression], given: set[str]) -> Iterator[Relation]:
    """Yield relations that give the quantities in the formula of the goal in terms of what is given."""
    whole, names = goal, _parts(goal, formulas, given)
    while len(names) == 1 and (deeper := _parts(names[0], formulas, given)):
        whole, names = names[0], deeper
    put_in = Substitution(formulas, {name: name for name in given})
    for part in _summands(formulas[whole], names) or [Symbol(name) for name in names]:
        known = [other for name in part.symbols() for other in formulas[name].symbols()]
        if isinstance(part, Symbol) and all(name in given or not set(formulas[name].symbols()) for name in known):
            continue
        try:
            found = shortened(put_in.of(part))
        except ClosedFormError:
            continue
        if len(found.latex) <= LONG:
            yield Relation(part, found.expression, "derived")


def _summands(formula: Expression, names: Sequence[str]) -> list[Expression]:
    """Return the denominator of a fraction if it is a sum of exactly the quantities to be told; else nothing."""
    below = formula.below if isinstance(formula, Quotient) else formula
    alone = isinstance(below, Sum) and isinstance(formula, Quotient) and [*below.symbols()] == [*names]
    return [below] if alone else []


def _parts(name: str, formulas: Mapping[str, Expression], given: set[str]) -> list[str]:
    """Return the names in a formula that the solution defines itself."""
    return [other for other in dict.fromkeys(formulas[name].symbols()) if other in formulas and other not in given]
