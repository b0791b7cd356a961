"""Products and fractions as a number times powers of factors, so that equal factors combine and cancel."""

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce

from sim2reason.solutions.algebra.expressions import (
    ONE,
    Expression,
    Number,
    Product,
    Quotient,
    Sum,
    Symbol,
    multiplied,
)
from sim2reason.solutions.algebra.functions import Absolute, Call, Pi, Power, Root

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

    def raised(self, exponent: int) -> "Factors":
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
        return reduce(multiplied, (_raised(base, power) for base, power in factors), Number(self.number))

    def written(self) -> Expression:
        """Return the formula, as a fraction if an exponent is negative."""
        above, below = (side.product() for side in self.sides())
        return above if below == ONE else Quotient(above, below)

    def never_negative(self) -> bool:
        """Return whether the product is at least zero for all values of its symbols."""
        return self.number >= 0.0 and all(power % 2 == 0 or never_negative(base) for base, power in self.powers.items())


def factors_of(held: Expression, of_sum: Callable[[Sum], Expression] = lambda held: held) -> Factors:
    """Return a formula as powers of its factors; `of_sum` replaces each sum among them."""
    match held:
        case Number(x):
            return Factors(x, {})
        case Product(factors):
            return reduce(Factors.__mul__, (factors_of(factor, of_sum) for factor in factors))
        case Quotient(above, below):
            return factors_of(above, of_sum) * factors_of(below, of_sum).raised(-1)
        case Power(base, exponent):
            return factors_of(base, of_sum).raised(exponent)
        case Sum() if (whole := of_sum(held)) != held:
            return factors_of(whole, of_sum)
        case _:
            return Factors(1.0, {held: 1})


def integer_sides(number: float) -> tuple[float, float]:
    """Return the signed numerator and the denominator of a number; the number and 1 if it is no simple fraction."""
    if number.is_integer():
        return number, 1.0
    fraction = Fraction(number).limit_denominator(LARGEST_DENOMINATOR)
    if abs(float(fraction) - number) > NUMBER_RTOL * abs(number):
        return number, 1.0
    return float(fraction.numerator), float(fraction.denominator)


def never_negative(held: Expression) -> bool:
    """Return whether a formula is at least zero for all values of its symbols."""
    match held:
        case Number(x):
            return x >= 0.0
        case Symbol(name):
            letter = LETTER.match(name)
            return letter is not None and letter[0] in NEVER_NEGATIVE
        case Root() | Pi() | Call("exp"):
            return True
        case Sum() | Product() | Quotient():
            return all(map(never_negative, held.parts))
        case Power(base, exponent):
            return exponent % 2 == 0 or never_negative(base)
        case _:
            return False


def has_fraction(held: Expression) -> bool:
    """Return whether a formula contains a fraction outside the arguments of functions."""
    return any(True for _ in _fractions(held))


def _fractions(held: Expression) -> Iterator[Expression]:
    match held:
        case Quotient():
            yield held
        case Number(x) if not x.is_integer() and integer_sides(x)[1] != 1.0:
            yield held
        case Call() | Number():
            return
        case _:
            for part in held.parts:
                yield from _fractions(part)


def _raised(base: Expression, power: int) -> Expression:
    return base if power == 1 else Power(base, power)


def factor_rank(held: Expression) -> int:
    """Return the sort key of a factor: numbers, symbols, sums, roots, functions, fractions."""
    base = held.base if isinstance(held, Power) else held
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
