"""Comparisons that verify an assumption of a solution."""

from sim2reason.solutions.algebra.expressions import Expression
from sim2reason.solutions.solution import Relation
from sim2reason.solutions.writing.steps import Book, UnsolvedError, Writing


def exceeds(book: Book, step: Writing, left: Expression, right: Expression) -> None:
    """Record in a step that one formula is larger than another; UnsolvedError if it is not."""
    if not book.value(left) > book.value(right):
        raise UnsolvedError(f"{left.latex()} does not exceed {right.latex()}")
    step.relations.append(Relation(left, right, "exceeds"))
