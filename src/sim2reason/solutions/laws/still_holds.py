"""Comparisons that a solution rests on, made again for another value of a given number."""

from sim2reason.solutions.algebra.expressions import Expression, Symbol
from sim2reason.solutions.algebra.inverse import put
from sim2reason.solutions.laws.nested import NEW
from sim2reason.solutions.solution import Relation, Step
from sim2reason.solutions.writing.comparing import exceeds
from sim2reason.solutions.writing.steps import Book, Writing
from sim2reason.solutions.writing.subscripts import marked


def verify_again(book: Book, symbol: str, changed: Expression, lead: str) -> None:
    """Write that what exceeds something else, by formulas of given numbers, does so with `changed` for a symbol.

    UnsolvedError where it does not.
    """
    found = {name for step in book.steps for name in step.gives}
    for step in [*book.steps]:
        for held in step.relations:
            symbols = {*held.symbols()}
            if held.role == "exceeds" and symbol in symbols and symbols.isdisjoint(found):
                _verify(book, step, held, (symbol, changed, lead))


def _verify(book: Book, step: Step, held: Relation, change: tuple[str, Expression, str]) -> None:
    symbol, changed, lead = change
    writing = book.open("verify")
    left, right = (put(side, symbol, changed) for side in (held.left, held.right))
    exceeds(book, writing, left, right)
    said = [_told(writing, step, pair) for pair in ((held.left, left), (held.right, right))]
    writing.say(f"{lead}, {said[0]} still exceeds {said[1]}.")
    writing.close()


def _told(writing: Writing, step: Step, sides: tuple[Expression, Expression]) -> str:
    """Return one side of a comparison: its new value, or its name where it stays what it is."""
    before, after = sides
    named = next((r for r in step.relations if r.role == "verified" and r.right == before), None)
    if named is None or before == after:
        return f"${(after if named is None else named.left).latex()}$"
    name = Symbol(marked(named.left.latex(), NEW))
    return writing.verified(name, after, named.unit)
