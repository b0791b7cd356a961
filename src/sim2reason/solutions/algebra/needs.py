"""What mathematics it takes to work out an expression."""

from collections.abc import Iterable, Mapping
from functools import cache

from sim2reason.questions.need import Need, greatest
from sim2reason.solutions.algebra.evaluated import (
    Chain,
    ClosedRoot,
    NumericRoot,
    QuadraticRoot,
    SpecialFunction,
    Worked,
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
    Worked: Need.ARITHMETIC,
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
DIRECT = frozenset[Function]({"sin", "cos", "tan"})  # of known angles; all other functions undo something


def need_of(held: Expression) -> Need:
    """Return what it takes to work out an expression where all its symbols have values."""
    cls = type(held)
    if cls in LEAVES:
        return Need.ARITHMETIC
    direct = isinstance(held, Call) and held.function in DIRECT
    own = Need.ARITHMETIC if direct else operation(cls)
    return max(own, greatest(map(need_of, _inside(held))))


@cache
def operation(cls: type[Expression]) -> Need:
    """Return what `OPERATIONS` declares for a class of expressions; KeyError if nothing."""
    return OPERATIONS[next((base for base in cls.__mro__ if base in OPERATIONS), cls)]


def _inside(held: Expression) -> Iterable[Expression]:
    match held:
        case Worked():
            return (held.inner,)
        case ClosedRoot():
            return (held.closed,)
        case NumericRoot():
            return (held.residual,)
        case Chain():
            return (formula for _, formula in held.formulas)
        case _:
            return held.parts
