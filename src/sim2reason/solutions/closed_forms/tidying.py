"""The last touch to a formula: no minus sign that a square takes away, no fraction under a root under a fraction."""

from collections.abc import Mapping
from functools import reduce

from sim2reason.solutions.algebra.expressions import (
    ONE,
    ZERO,
    Expression,
    Number,
    Product,
    Quotient,
    Sum,
    multiplied,
    ratio,
)
from sim2reason.solutions.algebra.functions import Absolute, Call, Power, Root

AT_ZERO: Mapping[str, Expression] = {"sin": ZERO, "cos": ONE, "arcsin": ZERO, "arctan": ZERO}


def tidied(held: Expression) -> Expression:
    """A formula with the same value, in each of whose parts signs and fractions stand as one would write them."""
    if not held.parts:
        return held
    found = held.built_of([tidied(part) for part in held.parts])
    match found:
        case Power(base, exponent):
            return _raised(base, exponent)
        case Absolute(inside) | Call(_, inside) if inside.negative:
            return _outward(found, _opposite(inside))
        case Call(function, Number(0.0)):
            return AT_ZERO.get(function, found)
        case Product(factors):
            return _fraction(_cancelled([_signed(factor) for factor in factors]))
        case _:
            return _fraction(found)


def _fraction(held: Expression) -> Expression:
    """A fraction without a minus sign where a difference below it can be taken the other way round; else as it is."""
    match held:
        case Product((Number(-1.0), Quotient(above, Sum() as below))):
            return _upright(above, -below)
        case Quotient(above, Sum() as below) if _signed(above).negative:
            return _upright(-_signed(above), -below)
        case Quotient(above, below):
            return _upright(above, below) if above == _signed(above) else -_upright(-above, below)
        case _:
            return held


def _raised(base: Expression, exponent: int) -> Expression:
    """A power as one would write it."""
    if isinstance(base, Call) and base.function == "exp":
        return Call("exp", _times(Number(float(exponent)), base.argument))
    return Power(base, exponent) if exponent % 2 else _squared(base, exponent)


def _times(number: Number, held: Expression) -> Expression:
    """A multiple, within the numerator of a fraction."""
    if isinstance(held, Quotient):
        return ratio(multiplied(number, held.above), held.below)
    return multiplied(number, held)


def _outward(held: Absolute | Call, opposite: Expression) -> Expression:
    """What has a negative argument, by that argument's opposite, where it is even or odd."""
    match held:
        case Absolute():
            return Absolute(opposite)
        case Call("cos"):
            return Call("cos", opposite)
        case Call("sin" | "arcsin" | "arctan" as function):
            return -Call(function, opposite)
        case _:
            return held


def _opposite(held: Expression) -> Expression:
    """What is negative without its sign."""
    return ratio(-held.above, held.below) if isinstance(held, Quotient) else -held


def _signed(held: Expression) -> Expression:
    """A sum of nothing but negative terms with its sign in front."""
    return multiplied(Number(-1.0), -held) if isinstance(held, Sum) and held.negative else held


def _upright(above: Expression, below: Expression) -> Expression:
    """A fraction whose denominator is none, nor the root of one."""
    match below:
        case Quotient(over, under):
            return ratio(multiplied(above, under), over)
        case Root(Quotient(over, under)):
            return multiplied(above, Root(ratio(under, over)))
        case _:
            return ratio(above, below)


def _cancelled(factors: list[Expression]) -> Expression:
    """A product without what stands in it once as a factor and once below a fraction."""
    for place, fraction in enumerate(factors):
        if isinstance(fraction, Quotient):
            below = list(fraction.below.factors if isinstance(fraction.below, Product) else (fraction.below,))
            common = next((factor for factor in factors if factor in below), None)
            if common is not None:
                below.remove(common)
                left = [
                    ratio(fraction.above, reduce(multiplied, below, ONE)) if n == place else factor
                    for n, factor in enumerate(factors)
                ]
                left.remove(common)
                return _cancelled(left)
    return reduce(multiplied, factors, ONE)


def _squared(base: Expression, exponent: int) -> Expression:
    """An even power: of each factor where one is a root, which it takes away; a number's is a number."""
    if isinstance(base, Number):
        return Number(base.x**exponent)
    if isinstance(base, Root):
        return base.inside if exponent == 2 else Power(base.inside, exponent // 2)
    if isinstance(base, Product) and any(isinstance(factor, Root) for factor in base.factors):
        return reduce(multiplied, (_squared(factor, exponent) for factor in base.factors), ONE)
    return Power(-base if base.negative else base, exponent)
