"""Sentences about roots that are found numerically, or about their equations if these contain the unknown."""

from collections.abc import Sequence

from sim2reason.solutions.algebra.evaluated import ImplicitRoot, NumericRoot
from sim2reason.solutions.algebra.expressions import ZERO, Expression, Symbol
from sim2reason.solutions.algebra.inverse import solved_for
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder

MAX_FORMULA_LENGTH = 160  # maximum length of the LaTeX of a formula that is written out
NamedRoot = tuple[Symbol, Expression, float]
"""The symbol of a root, the formula that vanishes there, and a number near it."""
SMALLEST = "The smallest positive solution, found numerically, is"


def root_sentence(
    book: SolutionBuilder, step: StepBuilder, name: Symbol, residual: Expression, near: float, unit: str, said: str
) -> str:
    """Return a sentence that gives a name the value of the root of `residual` near a number, in closed form if short.

    If the equation has a short solution, the sentence gives its formula without the words `said`. Otherwise, if the
    formula depends on the unknown, the sentence is empty: the equation, which was stated, defines the name.
    """
    closed = solved_for(name.name, residual, ZERO, {**book.values, name.name: near})
    if not isinstance(closed, NumericRoot) and len(closed.latex()) <= MAX_FORMULA_LENGTH:
        return f"Hence {step.result(name, closed, unit)}."
    return roots_sentence(book, step, [(name, residual, near)], unit, said)


def roots_sentence(book: SolutionBuilder, step: StepBuilder, roots: Sequence[NamedRoot], unit: str, said: str) -> str:
    """Return a sentence with the numerical roots of several formulas; empty if they depend on the unknown."""
    told, hidden = list[str](), False
    for name, residual, near in roots:
        hidden = hidden or not book.hidden.isdisjoint(residual.symbols())
        told.append(step.result(name, (ImplicitRoot if hidden else NumericRoot)(residual, name.name, near), unit))
    return "" if hidden else f"{said} {join_words(told)}."
