"""Inequalities that verify an assumption of a solution."""

from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.solution import Relation
from sim2reason.solutions.writing.steps import Book, UnsolvedError, Writing


def exceeds(book: Book, step: Writing, left: Expression, right: Expression) -> None:
    """Record in a step that one formula is larger than another; raise UnsolvedError if it is not."""
    if not book.value(left) > book.value(right):
        raise UnsolvedError(f"{left.latex()} does not exceed {right.latex()}")
    step.relations.append(Relation(left, right, "exceeds"))


def verify_assumed(book: Book, greater: Expression, less: Expression, relation: str) -> None:
    """Write that one formula is larger than another, as was assumed; `relation` is the LaTeX of it."""
    step = book.open("verify")
    exceeds(book, step, greater, less)
    step.say(f"Indeed ${relation}$, as was assumed.")
    step.close()


def why_this_time(book: Book, step: Writing, found: Symbol, other: Expression) -> str:
    """Return a clause that excludes the other of two solutions for a time; empty in symbols."""
    if book.in_symbols:
        return ""
    if book.value(other) < 0.0:
        exceeds(book, step, ZERO, other)
        return "; the other root is negative"
    if book.value(other) > book.value(found):
        exceeds(book, step, other, found)
        return "; the other root is later"
    return ""
