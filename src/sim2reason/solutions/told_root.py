"""Roots that are found numerically, told by their equations where those hang on what is unknown."""

from sim2reason.solutions.book import Book, Writing
from sim2reason.solutions.expressions import Expression, Symbol
from sim2reason.solutions.worked import ImplicitRoot, NumericRoot


def told_root(book: Book, step: Writing, name: Symbol, residual: Expression, near: float, unit: str, said: str) -> str:
    """What `said` announces: a name, and the number near one at which a formula of it vanishes.

    Where the formula hangs on what is unknown, only that the name is such a root.
    """
    hidden = not book.hidden.isdisjoint(residual.symbols())
    told = step.result(name, (ImplicitRoot if hidden else NumericRoot)(residual, name.name, near), unit)
    return f"Let ${name.name}$ be that root." if hidden else f"{said} {told}."
