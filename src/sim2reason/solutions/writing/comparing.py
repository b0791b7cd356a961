"""Inequalities that verify an assumption of a solution."""

from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.solution import Relation
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder, UnsolvedError


def record_inequality(book: SolutionBuilder, step: StepBuilder, left: Expression, right: Expression) -> None:
    """Record in a step that one formula is larger than another; raise UnsolvedError if it is not."""
    if not book.value(left) > book.value(right):
        raise UnsolvedError(f"{left.latex()} does not exceed {right.latex()}")
    step.relations.append(Relation(left, right, "exceeds"))


def verify_assumed(book: SolutionBuilder, greater: Expression, less: Expression, relation: str) -> None:
    """Write that one formula is larger than another, as was assumed; `relation` is this inequality in LaTeX."""
    step = book.begin_step("verify")
    record_inequality(book, step, greater, less)
    step.add_text(f"Indeed ${relation}$, as was assumed.")
    step.close()


def why_this_time(book: SolutionBuilder, step: StepBuilder, found: Symbol, other: Expression) -> str:
    """Return a clause that the `other` root for a time is negative or later; empty for a solution in symbols."""
    if book.in_symbols:
        return ""
    if book.value(other) < 0.0:
        record_inequality(book, step, ZERO, other)
        return "; the other root is negative"
    if book.value(other) > book.value(found):
        record_inequality(book, step, other, found)
        return "; the other root is later"
    return ""
