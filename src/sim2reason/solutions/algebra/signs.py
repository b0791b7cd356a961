"""Signs as one would write them: none that cancel each other, and none before a difference that can be reversed."""

from collections.abc import Sequence
from functools import reduce

from sim2reason.solutions.algebra.evaluated import Worked
from sim2reason.solutions.algebra.expressions import Expression, Number, Product, Quotient, Sum, multiplied, ratio
from sim2reason.solutions.algebra.functions import Call, Power

ODD = ("sin", "tan", "arcsin", "arctan")


def with_plain_signs(held: Expression) -> Expression:
    """Return a formula with the same value whose signs stand as one would write them."""
    if not held.parts or isinstance(held, Worked):
        return held
    found = held.built_of([with_plain_signs(part) for part in held.parts])
    if isinstance(found, Power) and found.base.negative and found.exponent % 2 == 0:
        return Power(_opposite(found.base), found.exponent)
    if isinstance(found, Call) and found.argument.negative and found.function in (*ODD, "cos"):
        turned = Call(found.function, _opposite(found.argument))
        return turned if found.function == "cos" else -turned
    if isinstance(found, Product):
        return _product(found.factors)
    return _fraction(found) if isinstance(found, Quotient) else found


def _product(factors: Sequence[Expression]) -> Expression:
    """Return a product of positive factors, with at most one sign before it."""
    sign, kept = 1.0, list[Expression]()
    for factor in factors:
        turned = factor.negative if not isinstance(factor, Worked) else factor.comes_to < 0.0
        sign = -sign if turned else sign
        kept.append(_opposite(factor) if turned else factor)
    whole = reduce(multiplied, kept)
    return whole if sign > 0.0 else _negated(whole)


def _negated(held: Expression) -> Expression:
    """Return the negative of a formula; a fraction whose denominator is a difference has that reversed."""
    if isinstance(held, Quotient) and is_difference(held.below):
        return Quotient(held.above, -held.below)
    return multiplied(Number(-1.0), held)


def _fraction(held: Quotient) -> Expression:
    """Return a fraction with the sign of its numerator in front, or with a difference in its denominator reversed."""
    if held.above.negative and is_difference(held.below):
        return Quotient(_opposite(held.above), -held.below)
    if isinstance(held.above, Sum) and held.above.negative:
        return multiplied(Number(-1.0), Quotient(-held.above, held.below))
    return held


def is_difference(held: Expression) -> bool:
    """Return whether a formula is a sum with terms of both signs."""
    return isinstance(held, Sum) and len({term.negative for term in held.terms}) > 1


def _opposite(held: Expression) -> Expression:
    """Return the formula without its leading minus sign."""
    return ratio(_opposite(held.above), held.below) if isinstance(held, Quotient) else -held
