"""Signs and fractions in simplified formulas: no redundant minus signs, no nested fractions in roots."""

from collections.abc import Mapping
from functools import reduce
from math import copysign, prod, sqrt

from sim2reason.solutions.algebra.expressions import (
    ONE,
    ZERO,
    Expression,
    Number,
    Product,
    Quotient,
    Sum,
    multiply_factors,
    ratio,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import PI, Absolute, Call, Power, Root, is_difference

AT_ZERO: Mapping[str, Expression] = {"sin": ZERO, "cos": ONE, "arcsin": ZERO, "arctan": ZERO}


def tidy(expression: Expression) -> Expression:
    """Simplify the signs and fractions in all parts of a formula; its value is unchanged."""
    if not expression.parts:
        return expression
    rebuilt = expression.built_of([tidy(part) for part in expression.parts])
    match rebuilt:
        case Power(base, exponent):
            return _raised(base, exponent)
        case Absolute() | Call():
            return _function(rebuilt)
        case Root():
            return _root(rebuilt)
        case _:
            return _joined(rebuilt)


def _function(expression: Absolute | Call) -> Expression:
    """Return an absolute value or function without redundant minus signs and multiples of π in its argument."""
    match expression:
        case Absolute(inside) | Call(_, inside) if inside.negative:
            return _outward(expression, _opposite(inside))
        case Call(function, Number(0.0)):
            return AT_ZERO.get(function, expression)
        case Call("cos" | "sin", Sum() as angle):
            return _whole_turns(expression, angle)
        case _:
            return expression


def _whole_turns(call: Call, angle: Sum) -> Expression:
    """Return a sine or cosine without the multiples of π in its argument."""
    halves, rest = 0.0, list[Expression]()
    for term in angle.terms:
        match term:
            case _ if term == PI:
                halves += 1.0
            case Product((Number(x), other)) if other == PI and x.is_integer():
                halves += x
            case _:
                rest.append(term)
    if not halves or not rest:
        return call
    reduced = tidy(Call(call.function, reduce(sum_terms, rest)))
    return -reduced if halves % 2.0 else reduced


def _joined(expression: Expression) -> Expression:
    """Return a product, fraction or sum in its usual notation."""
    if isinstance(expression, Product):
        expression = _over_one(_cancelled([_signed(factor) for factor in expression.factors]))
        return _rooted(_remove_leading_minus(_fraction(expression)))
    if isinstance(expression, Quotient) and not {*_factors(expression.above)}.isdisjoint(_factors(expression.below)):
        expression = _over_one(expression)
    return _remove_leading_minus(_fraction(expression))


def _over_one(part: Expression) -> Expression:
    """Return a product that contains fractions as a single fraction, with common factors cancelled."""
    factors = _factors(part)
    symbolic = [factor for factor in factors if not isinstance(factor, Number)]
    alone = len(symbolic) < 2 and not isinstance(part, Quotient)
    if alone or not any(isinstance(factor, Quotient) for factor in symbolic):
        return part
    above, below = list[Expression](), list[Expression]()
    for factor in factors:
        above += _factors(factor.above) if isinstance(factor, Quotient) else (factor,)
        below += _factors(factor.below) if isinstance(factor, Quotient) else ()
    above.sort(key=_place)
    for factor in [part for part in below if not isinstance(part, Number)]:
        if factor in above:
            above.remove(factor)
            below.remove(factor)
    size = prod(f.x for f in above if isinstance(f, Number)) / prod(f.x for f in below if isinstance(f, Number))
    over, under = (
        reduce(multiply_factors, (f for f in part if not isinstance(f, Number)), ONE) for part in (above, below)
    )
    if abs(size) < 1.0 and (1.0 / size).is_integer():
        return ratio(
            multiply_factors(Number(copysign(1.0, size)), over), multiply_factors(Number(abs(1.0 / size)), under)
        )
    return ratio(multiply_factors(Number(size), over), under)


def _root(root: Root) -> Expression:
    """Return a root with √(1/x) written as 1/√x, and square numbers and even powers of π taken out of it."""
    match root.inside:
        case Quotient(Number(1.0), below):
            return ratio(ONE, _root(Root(below)))
        case Product((Number(x), *rest)) if x > 1.0 and sqrt(x).is_integer():
            return multiply_factors(Number(sqrt(x)), _root(Root(reduce(multiply_factors, rest))))
        case Product(factors) if squared := [f for f in factors if isinstance(f, Power) and f.base == PI]:
            (power,) = squared
            left = reduce(multiply_factors, (factor for factor in factors if factor is not power), ONE)
            if power.exponent % 2 or power.exponent <= 0:
                return root
            return multiply_factors(_power_of_pi(power.exponent // 2), Root(left))
        case _:
            return root


def _power_of_pi(exponent: int) -> Expression:
    """Return a power of π."""
    return PI if exponent == 1 else Power(PI, exponent)


def _place(factor: Expression) -> int:
    """Return the rank by which factors are ordered in a product: symbols, sums, roots, functions."""
    base = factor.base if isinstance(factor, Power) else factor
    return 3 if isinstance(base, Call) else 2 if isinstance(base, Root) else 1 if isinstance(base, Sum) else 0


def _factors(expression: Expression) -> tuple[Expression, ...]:
    """Return the factors of a product; other formulas are their own only factor."""
    return expression.factors if isinstance(expression, Product) else (expression,)


def _remove_leading_minus(expression: Expression) -> Expression:
    """Remove the leading minus sign of a product by reversing a difference among its factors."""
    if isinstance(expression, Quotient) and isinstance(expression.above, Product) and expression.above.negative:
        return ratio(_remove_leading_minus(expression.above), expression.below)
    if (
        not isinstance(expression, Product)
        or not isinstance(expression.factors[0], Number)
        or expression.factors[0].x >= 0.0
    ):
        return expression
    number, *factors = expression.factors
    index = next((n for n, factor in enumerate(factors) if _holds_difference(factor)), None)
    if index is None:
        return expression
    factors[index] = _reversed(factors[index])
    return reduce(multiply_factors, factors, -number)


def _holds_difference(factor: Expression) -> bool:
    """Return whether a factor is a difference, or a fraction with one in its numerator."""
    if isinstance(factor, Quotient):
        return any(map(_holds_difference, _factors(factor.above)))
    return is_difference(factor)


def _opposed(expression: Expression) -> Expression:
    """Return the negative of a sum, or of a product with one of its sums reversed."""
    return (
        -expression
        if isinstance(expression, Sum)
        else _remove_leading_minus(multiply_factors(Number(-1.0), expression))
    )


def _reversed(expression: Expression) -> Expression:
    """Return a difference with its terms reversed."""
    return ratio(_opposed(expression.above), expression.below) if isinstance(expression, Quotient) else -expression


def _rooted(expression: Expression) -> Expression:
    """Return n √(a/(m b)) as √(n² a/(m b)) if n²/m is an integer, so that the fraction is reduced."""
    match expression:
        case Product((Number(x), Root(Quotient(above, Product((Number(y), *rest)))))) if (x * x / y).is_integer():
            return tidy(Root(ratio(multiply_factors(Number(x * x / y), above), reduce(multiply_factors, rest, ONE))))
        case _:
            return expression


def _fraction(expression: Expression) -> Expression:
    """Remove the minus sign of a fraction if a difference in its denominator can be reversed."""
    match expression:
        case Product((Number(-1.0), Quotient(above, Sum() as below))):
            return _upright(above, -below)
        case Quotient(above, Sum() as below) if _signed(above).negative:
            return _upright(-_signed(above), -below)
        case Quotient(above, below):
            return _upright(above, below) if above == _signed(above) else -_upright(-above, below)
        case _:
            return expression


def _raised(base: Expression, exponent: int) -> Expression:
    """Return an integer power in its usual notation."""
    if isinstance(base, Quotient) and base.above == ONE:
        return ratio(ONE, Power(base.below, exponent))
    if isinstance(base, Call) and base.function == "exp":
        return Call("exp", _times(Number(float(exponent)), base.argument))
    return Power(base, exponent) if exponent % 2 else _squared(base, exponent)


def _times(number: Number, expression: Expression) -> Expression:
    """Return a multiple of a formula, with the number in the numerator of a fraction."""
    if isinstance(expression, Quotient):
        return ratio(multiply_factors(number, expression.above), expression.below)
    return multiply_factors(number, expression)


def _outward(expression: Absolute | Call, opposite: Expression) -> Expression:
    """Rewrite an even or odd function of a negative argument, given the `opposite` argument: sin(−x) as −sin x."""
    match expression:
        case Absolute():
            return Absolute(opposite)
        case Call("cos"):
            return Call("cos", opposite)
        case Call("sin" | "arcsin" | "arctan" as function):
            return -Call(function, opposite)
        case _:
            return expression


def _opposite(expression: Expression) -> Expression:
    """Return a negative formula without its sign."""
    return ratio(-expression.above, expression.below) if isinstance(expression, Quotient) else -expression


def _signed(expression: Expression) -> Expression:
    """Return a sum of negative terms with its sign in front."""
    return (
        multiply_factors(Number(-1.0), -expression)
        if isinstance(expression, Sum) and expression.negative
        else expression
    )


def _upright(above: Expression, below: Expression) -> Expression:
    """Return a quotient without a fraction, or root of a fraction, in its denominator."""
    match below:
        case Quotient(over, under):
            return ratio(multiply_factors(above, under), over)
        case Root(Quotient(over, under)):
            return multiply_factors(above, Root(ratio(under, over)))
        case _:
            return ratio(above, below)


def _cancelled(factors: list[Expression]) -> Expression:
    """Return a product without the factors that a fraction among them cancels."""
    for index, fraction in enumerate(factors):
        if isinstance(fraction, Quotient):
            below = list(fraction.below.factors if isinstance(fraction.below, Product) else (fraction.below,))
            common = next((factor for factor in factors if factor in below), None)
            if common is not None:
                below.remove(common)
                left = [
                    ratio(fraction.above, reduce(multiply_factors, below, ONE)) if n == index else factor
                    for n, factor in enumerate(factors)
                ]
                left.remove(common)
                return _cancelled(left)
    return reduce(multiply_factors, factors, ONE)


def _squared(base: Expression, exponent: int) -> Expression:
    """Return an even power factor by factor if a factor is a root, which the power removes."""
    if isinstance(base, Number):
        return Number(base.x**exponent)
    if isinstance(base, Power):
        return Power(base.base, base.exponent * exponent)
    if isinstance(base, Root):
        return base.inside if exponent == 2 else Power(base.inside, exponent // 2)
    if isinstance(base, Product) and any(isinstance(factor, Root) for factor in base.factors):
        return reduce(multiply_factors, (_squared(factor, exponent) for factor in base.factors), ONE)
    return Power(-base if base.negative else base, exponent)
