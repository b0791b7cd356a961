"""Roots that are found numerically, told by their equations where those hang on what is unknown."""

from collections.abc import Sequence

from sim2reason.solutions.algebra.evaluated import ImplicitRoot, NumericRoot
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.inverse import solved_for
from sim2reason.solutions.setting import joined
from sim2reason.solutions.writing.steps import Book, Writing

LONG = 160  # characters of a formula that is better not written
NamedRoot = tuple[Symbol, Expression, float]
"""What a root is called, the formula that vanishes there, and a number near it."""
SMALLEST = "The smallest positive solution, found numerically, is"


def told_root(book: Book, step: Writing, name: Symbol, residual: Expression, near: float, unit: str, said: str) -> str:
    """Return a sentence with the number near `near` at which a formula vanishes, as a value of the name in it.

    Where the equation can be solved, the formula of the root, without what `said` announces. Else, where the formula
    hangs on what is unknown, nothing: the equation, which was told, holds the name.
    """
    closed = solved_for(name.name, residual, ZERO, {**book.values, name.name: near})
    if not isinstance(closed, NumericRoot) and len(closed.latex()) <= LONG:
        return f"Hence {step.result(name, closed, unit)}."
    return told_roots(book, step, [(name, residual, near)], unit, said)


def told_roots(book: Book, step: Writing, roots: Sequence[NamedRoot], unit: str, said: str) -> str:
    """Return the same of several at once, one after the other."""
    told, hidden = list[str](), False
    for name, residual, near in roots:
        hidden = hidden or not book.hidden.isdisjoint(residual.symbols())
        told.append(step.result(name, (ImplicitRoot if hidden else NumericRoot)(residual, name.name, near), unit))
    return "" if hidden else f"{said} {joined(told)}."
