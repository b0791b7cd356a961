"""Transformations of formulas: derivatives, limits and factors."""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce

from sim2reason.solutions.algebra.expressions import (
    ONE,
    ZERO,
    Expression,
    Number,
    Product,
    Quotient,
    Sum,
    Symbol,
    multiply_factors,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import Absolute, Call, Function, Pi, Power, Root


def derivative(expression: Expression, name: str) -> Expression:
    """Return the derivative of a formula with respect to a symbol; TypeError for a part without a known rule."""
    if name not in expression.names:
        return ZERO
    match expression:
        case Symbol():
            result = ONE
        case Sum():
            result = reduce(sum_terms, (derivative(term, name) for term in expression.terms))
        case Product():
            result = reduce(sum_terms, (_by_one(expression, number, name) for number in range(len(expression.factors))))
        case Quotient():
            above, below = derivative(expression.above, name), derivative(expression.below, name)
            top = sum_terms(multiply_factors(above, expression.below), -multiply_factors(expression.above, below))
            result = above / expression.below if below == ZERO else top / Power(expression.below, 2)
        case Power():
            rest = expression.base if expression.exponent == 2 else Power(expression.base, expression.exponent - 1)
            result = multiply_factors(
                Number(float(expression.exponent)), multiply_factors(rest, derivative(expression.base, name))
            )
        case Root():
            result = derivative(expression.inside, name) / multiply_factors(Number(2.0), expression)
        case Call():
            result = multiply_factors(_outer(expression), derivative(expression.argument, name))
        case _:
            raise TypeError(f"no rule for the derivative of {type(expression).__name__}")
    return result


def _by_one(product: Product, number: int, name: str) -> Expression:
    """Return a product with one factor replaced by its derivative."""
    factors = (derivative(f, name) if n == number else f for n, f in enumerate(product.factors))
    return reduce(multiply_factors, factors)


def _outer(call: Call) -> Expression:
    """Return the derivative of a function with respect to its argument."""
    x = call.argument
    arc = Root(ONE - Power(x, 2))
    rules: dict[Function, Expression] = {
        "sin": Call("cos", x),
        "cos": -Call("sin", x),
        "tan": ONE / Power(Call("cos", x), 2),
        "arctan": ONE / (ONE + Power(x, 2)),
        "arcsin": ONE / arc,
        "arccos": -(ONE / arc),
        "ln": ONE / x,
        "exp": call,
    }
    return rules[call.function]


CANCELLATION_RTOL = 1e-9  # relative: a smaller sum of leading terms counts as zero


class CancelledError(Exception):
    """An error raised if the leading terms of a sum cancel, so that the limit needs terms of higher order."""


def limit(expression: Expression, name: str, at: Mapping[str, float], *, large: bool) -> Expression | None:
    """Return the limit of a formula as a symbol tends to infinity (`large`) or zero; None if it is zero or infinite.

    `at` has values of the other symbols, which show the terms that cancel.

    Raises:
        CancelledError: leading terms cancel.
        TypeError: no rule is known for a part of the formula.
    """
    leading, power = _leading(expression, name, at, 1.0 if large else -1.0)
    return leading if power == 0.0 else None


def _leading(expression: Expression, name: str, at: Mapping[str, float], sense: float) -> tuple[Expression, float]:
    """Return coefficient and exponent of a formula's leading term for a symbol going to infinity (`sense` 1) or 0."""
    if name not in expression.names:
        return expression, 0.0
    match expression:
        case Symbol():
            leading_term: tuple[Expression, float] = ONE, 1.0
        case Sum():
            leading_term = _of_sum(expression, name, at, sense)
        case Product():
            parts = [_leading(factor, name, at, sense) for factor in expression.factors]
            leading_term = reduce(multiply_factors, (part for part, _ in parts)), sum(power for _, power in parts)
        case Quotient():
            (above, high), (below, low) = (
                _leading(part, name, at, sense) for part in (expression.above, expression.below)
            )
            leading_term = above / below, high - low
        case Power():
            base, power = _leading(expression.base, name, at, sense)
            leading_term = Power(base, expression.exponent), expression.exponent * power
        case Root() | Absolute():
            inside, power = _leading(expression.inside, name, at, sense)
            leading_term = expression.built_of([inside]), power if isinstance(expression, Absolute) else 0.5 * power
        case Call():
            argument, power = _leading(expression.argument, name, at, sense)
            if power != 0.0:
                raise TypeError("no rule for a function of what grows or vanishes")
            leading_term = Call(expression.function, argument), 0.0
        case _:
            raise TypeError(f"no rule for the limit of {type(expression).__name__}")
    return leading_term


def _of_sum(expression: Sum, name: str, at: Mapping[str, float], sense: float) -> tuple[Expression, float]:
    """Return coefficient and exponent of a sum's leading term; CancelledError if its leading terms cancel."""
    parts = [_leading(term, name, at, sense) for term in expression.terms]
    most = max(sense * power for _, power in parts)
    kept = [part for part, power in parts if sense * power == most]
    values = [part.value(at).real for part in kept]
    if abs(sum(values)) <= CANCELLATION_RTOL * max(map(abs, values)):
        raise CancelledError("leading terms cancel")
    return reduce(sum_terms, kept), sense * most


LARGEST_DENOMINATOR = 10**6  # largest denominator of a number that is written as a fraction
NUMBER_RTOL = 1e-13  # relative rounding error allowed in such a number
NEVER_NEGATIVE = {"m", "M", "k", "g", "R", "d", "t", r"\mu", r"\ell", r"\rho"}
"""Letters of masses, stiffnesses, lengths, times and coefficients, which no scene has with a minus sign."""
LETTER = re.compile(r"\\?[A-Za-z]+")


@dataclass(frozen=True, slots=True)
class Factors:
    """A number times integer powers of factors; factors of a denominator have negative exponents."""

    number: float
    powers: Mapping[Expression, int]

    def __mul__(self, other: "Factors") -> "Factors":
        """Return the product."""
        powers = dict(self.powers)
        for base, exponent in other.powers.items():
            powers[base] = powers.get(base, 0) + exponent
        return Factors(self.number * other.number, {base: power for base, power in powers.items() if power})

    def power(self, exponent: int) -> "Factors":
        """Return an integer power."""
        return Factors(self.number**exponent, {base: power * exponent for base, power in self.powers.items()})

    def sides(self) -> "tuple[Factors, Factors]":
        """Return the numerator and the denominator, with integer coefficients if the number is a simple fraction."""
        over, under = integer_sides(self.number)
        above = {base: power for base, power in self.powers.items() if power > 0}
        below = {base: -power for base, power in self.powers.items() if power < 0}
        return Factors(over, above), Factors(under, below)

    def product(self) -> Expression:
        """Return the product of all factors as a formula; all exponents must be positive."""
        factors = sorted(self.powers.items(), key=lambda factor: factor_rank(factor[0]))
        return reduce(multiply_factors, (_raised(base, power) for base, power in factors), Number(self.number))

    def as_formula(self) -> Expression:
        """Return the formula, as a fraction if an exponent is negative."""
        above, below = (side.product() for side in self.sides())
        return above if below == ONE else Quotient(above, below)

    def never_negative(self) -> bool:
        """Return whether the product is at least zero for all values of its symbols."""
        return self.number >= 0.0 and all(power % 2 == 0 or never_negative(base) for base, power in self.powers.items())


def factors_of(expression: Expression, of_sum: Callable[[Sum], Expression] = lambda expression: expression) -> Factors:
    """Return a formula as powers of its factors; `of_sum` replaces each sum among them."""
    match expression:
        case Number(x):
            return Factors(x, {})
        case Product(factors):
            return reduce(Factors.__mul__, (factors_of(factor, of_sum) for factor in factors))
        case Quotient(above, below):
            return factors_of(above, of_sum) * factors_of(below, of_sum).power(-1)
        case Power(base, exponent):
            return factors_of(base, of_sum).power(exponent)
        case Sum() if (replacement := of_sum(expression)) != expression:
            return factors_of(replacement, of_sum)
        case _:
            return Factors(1.0, {expression: 1})


def integer_sides(number: float) -> tuple[float, float]:
    """Return the signed numerator and the denominator of a number; the number and 1 if it is no simple fraction."""
    if number.is_integer():
        return number, 1.0
    fraction = Fraction(number).limit_denominator(LARGEST_DENOMINATOR)
    if abs(float(fraction) - number) > NUMBER_RTOL * abs(number):
        return number, 1.0
    return float(fraction.numerator), float(fraction.denominator)


def never_negative(expression: Expression) -> bool:
    """Return whether a formula is at least zero for all values of its symbols."""
    match expression:
        case Number(x):
            return x >= 0.0
        case Symbol(name):
            letter = LETTER.match(name)
            return letter is not None and letter[0] in NEVER_NEGATIVE
        case Root() | Pi() | Call("exp"):
            return True
        case Sum() | Product() | Quotient():
            return all(map(never_negative, expression.parts))
        case Power(base, exponent):
            return exponent % 2 == 0 or never_negative(base)
        case _:
            return False


def has_fraction(expression: Expression) -> bool:
    """Return whether a formula contains a fraction outside the arguments of functions."""
    return any(True for _ in _fractions(expression))


def _fractions(expression: Expression) -> Iterator[Expression]:
    match expression:
        case Quotient():
            yield expression
        case Number(x) if not x.is_integer() and integer_sides(x)[1] != 1.0:
            yield expression
        case Call() | Number():
            return
        case _:
            for part in expression.parts:
                yield from _fractions(part)


def _raised(base: Expression, power: int) -> Expression:
    return base if power == 1 else Power(base, power)


def factor_rank(expression: Expression) -> int:
    """Return the sort key of a factor: numbers, symbols, sums, roots, functions, fractions."""
    base = expression.base if isinstance(expression, Power) else expression
    match base:
        case Number() | Pi():
            return -1
        case Sum() | Absolute():
            return 5 if has_fraction(base) else 1
        case Root():
            return 4 if has_fraction(base) else 2
        case Call():
            return 3
        case _:
            return 0
