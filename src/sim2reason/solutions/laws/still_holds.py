"""Comparisons that a solution rests on, made again for another value of a given number."""

from collections.abc import Mapping, Sequence

from sim2reason.solutions.algebra.expressions import Expression, Symbol
from sim2reason.solutions.algebra.inverse import put
from sim2reason.solutions.closed_forms.closed_form import defined_by
from sim2reason.solutions.laws.nested import AGAIN, NEW
from sim2reason.solutions.solution import Relation, Step
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import Book, UnsolvedError, Writing
from sim2reason.solutions.writing.subscripts import marked

LONG = 200  # characters of a formula that is better not written; that it exceeds another is checked all the same
LONGEST = 1000  # characters of a formula into which nothing more is inserted, as it would only become longer


def verify_again(book: Book, symbol: str, changed: Expression, lead: str) -> None:
    """Write that each comparison that depends on a symbol still holds with `changed` in place of it.

    Raises:
        UnsolvedError: one does not.
    """
    formulas = {name: formula for name, formula in defined_by(book.steps).items() if name not in book.stated}
    hanging = _hanging(formulas, symbol)
    for step in [*book.steps]:
        for held in step.relations:
            if held.role == "exceeds" and not {symbol, *hanging}.isdisjoint(held.symbols()):
                sides = [_changed(side, symbol, changed, hanging) for side in (held.left, held.right)]
                left, right = sides
                if left is not None and right is not None:
                    _verify(book, step, held, (left, right), lead)
                else:
                    _exceeds_still(book, held, {symbol: changed, **dict(reversed(hanging.items()))})


def _hanging(formulas: Mapping[str, Expression], symbol: str) -> dict[str, Expression]:
    """Return the formulas of names that depend on a symbol, by name, the last defined one first."""
    found: dict[str, Expression] = {}
    for name, formula in formulas.items():
        if not {symbol, *found}.isdisjoint(formula.symbols()):
            found = {name: formula, **found}
    return found


def _changed(
    side: Expression, symbol: str, changed: Expression, hanging: Mapping[str, Expression]
) -> Expression | None:
    """Return a formula with `changed` for a symbol, also in formulas of names that depend on it; None if it is long."""
    for name, formula in {**hanging, symbol: changed}.items():
        side = put(side, name, formula)
        if len(side.latex()) > LONGEST:
            return None
    return side


def _exceeds_still(book: Book, held: Relation, formulas: Mapping[str, Expression]) -> None:
    """Check a comparison in numbers, with other formulas of names, each after those on which it depends.

    Raises:
        UnsolvedError: it does not hold.
    """
    at = dict(book.values)
    for name, formula in formulas.items():
        at[name] = book.value(formula, at)
    if not book.value(held.left, at) > book.value(held.right, at):
        raise UnsolvedError(f"{held.left.latex()} no longer exceeds {held.right.latex()}")


def _verify(book: Book, step: Step, held: Relation, sides: Sequence[Expression], lead: str) -> None:
    writing, (left, right) = book.open("verify"), sides
    exceeds(book, writing, left, right)
    if max(len(side.latex()) for side in sides) > LONG:
        return
    said = [_told(writing, step, pair) for pair in ((held.left, left), (held.right, right))]
    writing.say(f"{lead}, {said[0]} still exceeds {said[1]}.")
    writing.label(f"{AGAIN} {len(book.steps)}")
    writing.close()


def _told(writing: Writing, step: Step, sides: tuple[Expression, Expression]) -> str:
    """Return one side of a comparison: its new value, or its name where it stays what it is."""
    before, after = sides
    named = next((r for r in step.relations if r.role == "verified" and before in (r.left, r.right)), None)
    if named is None or before == after:
        return f"${(after if named is None else named.left).latex()}$"
    name = Symbol(marked(named.left.latex(), NEW))
    return writing.verified(name, after, named.unit)
