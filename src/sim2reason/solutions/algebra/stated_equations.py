"""Standard forms of equations, and formulas as one fraction or as powers of a symbol."""

from collections.abc import Callable, Iterator
from functools import reduce
from operator import mul

from sim2reason.solutions.algebra.closed_roots import (
    CoefficientWriter,
    PolynomialFraction,
    coefficient,
    expand_numbers,
    fraction,
    power_of,
    without_radicals,
)
from sim2reason.solutions.algebra.expressions import (
    ONE,
    Expression,
    Number,
    Product,
    Quotient,
    Symbol,
    added,
    multiplied,
)
from sim2reason.solutions.algebra.fractions import reduced_quotient
from sim2reason.solutions.algebra.functions import Call, Power, Root
from sim2reason.solutions.algebra.polynomials import Polynomial, common_monomial, divide_by_term


def stated_equation(
    name: str, formula: Expression, value: Expression, written: CoefficientWriter
) -> tuple[Expression, Expression] | None:
    """Reduce an equation to a x² + b x = c or a sin x + b cos x = c; return both sides, or None if it is neither.

    In the first form, x may also be the sine or the cosine of the symbol.
    """
    try:
        zero = without_radicals((fraction(expand_numbers(formula, name)) + fraction(-value)).above, name)
    except OverflowError:
        return None
    zero = divide_by_term(zero, common_monomial([*zero.terms]), 1.0) or zero
    symbol, sine, cosine = Symbol(name), Call("sin", Symbol(name)), Call("cos", Symbol(name))
    squares = ((atom, atom, (2, 1)) for atom in (symbol, sine, cosine))
    for first, second, powers in (*squares, (sine, cosine, (1, 1))):
        parts = [coefficient(zero, atom, power) for atom, power in zip((first, second), powers, strict=True)]
        rest = zero
        for part, atom, power in zip(parts, (first, second), powers, strict=True):
            rest = rest - part * Polynomial({((atom, power),): 1.0})
        if (
            not all(parts)
            or name in rest.expression().symbols()
            or any(name in p.expression().symbols() for p in parts)
        ):
            continue
        sign = -1.0 if written(parts[0]).negative else 1.0
        terms = (
            multiplied(written(part.scaled(sign)), power_of(atom, power))
            for part, atom, power in zip(parts, (first, second), powers, strict=True)
        )
        return reduce(added, terms), written(rest.scaled(-sign))
    return None


def as_one_fraction(formula: Expression, name: str, *, always: bool = False) -> Expression:
    """Return a formula of a symbol as one fraction if that is shorter; a square root keeps the fraction under it.

    With `always` it is one fraction of any length, with the common number of all terms in front.
    """
    if isinstance(formula, Root):
        return Root(as_one_fraction(formula.inside, name))
    plain = _without_squared_roots(formula)
    try:
        found = reduced_quotient(*_sides(fraction(expand_numbers(plain, name))), grouped=always)
    except OverflowError:
        return plain
    again = _without_squared_roots(found)  # squares of roots may appear once other terms have cancelled
    found = as_one_fraction(again, name) if again != found else found
    return found if always or len(found.latex()) < len(plain.latex()) else plain


def as_power(formula: Expression, name: str, worked: Callable[[Expression], Expression]) -> Expression | None:
    """Return a formula proportional to a power of a symbol as a number times that power; None for others."""
    try:
        above, below = _sides(fraction(expand_numbers(_without_squared_roots(formula), name)))
    except OverflowError:
        return None
    powers = {dict(monomial).get(Symbol(name), 0) for monomial in above.terms}
    if len(powers) != 1 or name in below.names():
        return None
    (power,) = powers
    rest = coefficient(above, Symbol(name), power)
    if power < 1 or name in rest.names():
        return None
    return multiplied(worked(reduced_quotient(rest, below)), power_of(Symbol(name), power))


def found_by_double_angle(formula: Expression, found: Expression, name: str) -> bool:
    """Return whether an angle is found as half of a double angle, from the squares of its sine and cosine."""
    squares = {Power(Call(function, Symbol(name)), 2) for function in ("sin", "cos")}
    halved = isinstance(found, Quotient) and found.below == Number(2.0)
    return halved and any(part in squares for part in _parts(formula))


def half_angles(name: str) -> list[tuple[Expression, Expression]]:
    """Return the half-angle formulas: pairs of cos² or sin² of an angle and its value by the double angle."""
    twice = Call("cos", multiplied(Number(2.0), Symbol(name)))
    halves = (added(ONE, twice), added(ONE, -twice))
    squares = (Power(Call("cos", Symbol(name)), 2), Power(Call("sin", Symbol(name)), 2))
    return [(square, multiplied(Number(0.5), half)) for square, half in zip(squares, halves, strict=True)]


def _parts(held: Expression) -> Iterator[Expression]:
    """Yield a formula and all of its subexpressions."""
    yield held
    for part in held.parts:
        yield from _parts(part)


def _without_squared_roots(held: Expression) -> Expression:
    """Replace squares of square roots by their radicands."""
    if not held.parts:
        return held
    held = held.built_of([_without_squared_roots(part) for part in held.parts])
    if not isinstance(held, Power) or held.exponent < 0 or held.exponent % 2:
        return held
    factors = held.base.factors if isinstance(held.base, Product) else (held.base,)
    if not any(isinstance(factor, Root) for factor in factors):
        return held
    half = held.exponent // 2
    squared = (power_of(f.inside, half) if isinstance(f, Root) else Power(f, held.exponent) for f in factors)
    return reduce(multiplied, squared)


def _sides(held: PolynomialFraction) -> tuple[Polynomial, Polynomial]:
    """Return the numerator and the expanded denominator of a fraction."""
    return held.above, reduce(mul, held.below, Polynomial.of(1.0))
