"""The mathematics that the evaluation of an expression needs."""

from collections.abc import Iterable, Mapping
from functools import cache

from sim2reason.questions.difficulty import Need, most_advanced
from sim2reason.solutions.algebra.evaluated import (
    Chain,
    ClosedRoot,
    NumericFormula,
    NumericRoot,
    QuadraticRoot,
    SpecialFunction,
)
from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Quotient, Sum, Symbol
from sim2reason.solutions.algebra.functions import Absolute, Call, Function, Pi, Power, Root

OPERATIONS: Mapping[type[Expression], Need] = {
    Number: Need.ARITHMETIC,
    Symbol: Need.ARITHMETIC,
    Pi: Need.ARITHMETIC,
    Sum: Need.ARITHMETIC,
    Product: Need.ARITHMETIC,
    Quotient: Need.ARITHMETIC,
    Power: Need.ARITHMETIC,
    Absolute: Need.ARITHMETIC,
    NumericFormula: Need.ARITHMETIC,
    Chain: Need.ARITHMETIC,
    ClosedRoot: Need.ARITHMETIC,
    Root: Need.QUADRATIC,
    Call: Need.INVERSE_FUNCTION,
    NumericRoot: Need.ROOT,
    QuadraticRoot: Need.QUADRATIC,
    SpecialFunction: Need.SPECIAL_FUNCTION,
}
"""What it takes to work out an expression of a class, or of a subclass, once all that is inside it is known."""
LEAVES = frozenset[type[Expression]]({Number, Symbol, Pi})
"""Classes without anything inside."""
DIRECT = frozenset[Function]({"sin", "cos", "tan"})  # functions of known angles; all other functions are inverse ones


def need_of(held: Expression) -> Need:
    """Return the most advanced mathematics that the evaluation of an expression needs."""
    cls = type(held)
    if cls in LEAVES:
        return Need.ARITHMETIC
    direct = isinstance(held, Call) and held.function in DIRECT
    own = Need.ARITHMETIC if direct else operation(cls)
    return max(own, most_advanced(map(need_of, _inside(held))))


@cache
def operation(cls: type[Expression]) -> Need:
    """Return the mathematics that the operation of a class of expressions needs; KeyError if none is recorded."""
    return OPERATIONS[next((base for base in cls.__mro__ if base in OPERATIONS), cls)]


def _inside(held: Expression) -> Iterable[Expression]:
    """Return the subexpressions that must be evaluated first; for a numerical root, its equation."""
    match held:
        case NumericFormula():
            return (held.inner,)
        case ClosedRoot():
            return (held.closed,)
        case NumericRoot():
            return (held.residual,)
        case Chain():
            return (formula for _, formula in held.formulas)
        case _:
            return held.parts
