"""What mathematics a worked solution takes, from arithmetic to numerical integration."""

from collections.abc import Iterable, Mapping
from enum import IntEnum
from functools import cache

from sim2reason.solutions.algebra.elliptic import SpecialFunction
from sim2reason.solutions.algebra.evaluated import Chain, NumericRoot, Worked
from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Quotient, Sum, Symbol
from sim2reason.solutions.algebra.functions import Absolute, Call, Function, Pi, Power, Root


class Need(IntEnum):
    """The most advanced operation that a calculation takes, in ascending order."""

    ARITHMETIC = 0
    """Sums, products, quotients, whole powers, and sines and cosines of known angles."""
    QUADRATIC = 1
    """A square root, or a quadratic equation."""
    INVERSE_FUNCTION = 2
    """An inverse trigonometric function, a logarithm or an exponential function."""
    ROOT = 3
    """An equation that is solved numerically, be it transcendental or of a higher degree."""
    SPECIAL_FUNCTION = 4
    """An elliptic integral."""
    INTEGRATION = 5
    """Equations of motion that are integrated numerically."""

    @property
    def label(self) -> str:
        """Its name in items, on the command line and in the docs."""
        return self.name.lower().replace("_", " ")


NEEDS = {need.label: need for need in Need}
"""All needs by their labels."""
EVERY = frozenset(Need)
ELEMENTARY = Need.INVERSE_FUNCTION
"""The greatest need that is met without a computer."""
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
    Root: Need.QUADRATIC,
    Call: Need.INVERSE_FUNCTION,
    NumericRoot: Need.ROOT,
    SpecialFunction: Need.SPECIAL_FUNCTION,
}
"""What it takes to work out an expression of a class, or of a subclass, once all that is inside it is known."""
DIRECT = frozenset[Function]({"sin", "cos", "tan"})  # of known angles; all other functions undo something


def need_of(held: Expression) -> Need:
    """Return what it takes to work out an expression where all its symbols have values."""
    direct = isinstance(held, Call) and held.function in DIRECT
    own = Need.ARITHMETIC if direct else operation(type(held))
    return max(own, greatest(map(need_of, _inside(held))))


@cache
def operation(cls: type[Expression]) -> Need:
    """Return what `OPERATIONS` declares for a class of expressions; KeyError if nothing."""
    return OPERATIONS[next((base for base in cls.__mro__ if base in OPERATIONS), cls)]


def greatest(needs: Iterable[Need]) -> Need:
    """Return the most advanced of some needs; ARITHMETIC if there are none."""
    return max(needs, default=Need.ARITHMETIC)


def _inside(held: Expression) -> Iterable[Expression]:
    match held:
        case Worked():
            return (held.inner,)
        case NumericRoot():
            return (held.residual,)
        case Chain():
            return (formula for _, formula in held.formulas)
        case _:
            return held.parts
