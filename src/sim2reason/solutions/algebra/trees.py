"""Formulas as prefix trees of JSON values, such as ``["+", ["*", "m", "g"], 3.0]``; strings are symbols."""

from functools import singledispatch
from typing import TypeAlias

from sim2reason.solutions.algebra.digits import round_to_digits
from sim2reason.solutions.algebra.evaluated import (
    Amplitude,
    Chain,
    CompleteElliptic,
    IncompleteElliptic,
    NumericFormula,
    NumericRoot,
)
from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Quotient, Sum, Symbol
from sim2reason.solutions.algebra.functions import Absolute, Call, Pi, Power, Root

Tree: TypeAlias = float | str | list["Tree"]


@singledispatch
def tree(held: Expression) -> Tree:
    """Convert a formula to a prefix tree; TypeError for a class without a tree."""
    raise TypeError(f"{type(held).__name__} has no tree; register one in {__name__}")


@tree.register
def _(held: Number) -> Tree:
    return float(held.x)


@tree.register
def _(held: Symbol) -> Tree:
    return held.name


@tree.register
def _(held: Sum) -> Tree:
    return ["+", *map(tree, held.terms)]


@tree.register
def _(held: Product) -> Tree:
    return ["*", *map(tree, held.factors)]


@tree.register
def _(held: Quotient) -> Tree:
    return ["/", tree(held.above), tree(held.below)]


@tree.register
def _(held: Power) -> Tree:
    return ["^", tree(held.base), float(held.exponent)]


@tree.register
def _(held: Root) -> Tree:
    return ["sqrt", tree(held.inside)]


@tree.register
def _(held: Absolute) -> Tree:
    return ["abs", tree(held.inside)]


@tree.register
def _(held: Call) -> Tree:
    return [held.function, tree(held.argument)]


@tree.register
def _(held: Pi) -> Tree:
    del held
    return ["pi"]


@tree.register
def _(held: CompleteElliptic) -> Tree:
    return ["elliptic K", tree(held.modulus)]


@tree.register
def _(held: IncompleteElliptic) -> Tree:
    return ["elliptic F", tree(held.argument), tree(held.modulus)]


@tree.register
def _(held: Amplitude) -> Tree:
    return ["amplitude", tree(held.argument), tree(held.modulus)]


@tree.register
def _(held: NumericFormula) -> Tree:
    """Return the tree of a formula together with the rounded number in the text, so that both can be compared."""
    return ["worked", tree(held.inner), float(held.comes_to)]


@tree.register
def _(held: NumericRoot) -> Tree:
    """Return the tree of a numerical root: its equation and its value, rounded as in the text.

    For a chain of formulas in earlier relations, those relations are the equation.
    """
    near = round_to_digits(held.near)
    return ["solve", near] if _has_chain(held.residual) else ["root", held.name, tree(held.residual), near]


def _has_chain(held: Expression) -> bool:
    """Return whether a formula contains a chain."""
    return isinstance(held, Chain) or any(map(_has_chain, held.parts))
