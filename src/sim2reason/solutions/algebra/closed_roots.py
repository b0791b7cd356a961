"""Closed-form roots of equations that are linear or quadratic in a symbol, or in its sine or cosine."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import lru_cache, reduce
from operator import add, mul

from sim2reason.solutions.algebra.evaluated import NumericFormula
from sim2reason.solutions.algebra.expressions import (
    ZERO,
    Expression,
    Number,
    Product,
    Quotient,
    Sum,
    Symbol,
    multiply_factors,
    ratio,
    sum_terms,
)
from sim2reason.solutions.algebra.fractions import cancel_common_sum, reduced_quotient
from sim2reason.solutions.algebra.functions import PI, Call, Function, Power, Root
from sim2reason.solutions.algebra.polynomials import Monomial, Polynomial, common_monomial, divide_by_term

MAX_TERMS = 60  # terms of an equation that is solved in symbols, at most
MAX_DEGREE = 2  # highest degree of an equation that is solved
MAX_TERMS_WITH_ROOTS = 12  # terms of an equation with several square roots, at most
MAX_SQUARE_ROOTS = 2  # different square roots with the symbol in one equation, at most


CoefficientWriter = Callable[[Polynomial], Expression]


def roots(
    name: str, formula: Expression, value: Expression, written: CoefficientWriter = Polynomial.factored
) -> Iterator[Expression]:
    """Yield closed forms of a symbol that may solve formula = value, of it and its sines, cosines and square roots.

    Squaring may add extraneous roots. `written` converts coefficients to formulas.
    """
    rational = polynomial_equation(name, formula, value)
    if rational is None:
        return
    atoms = {atom for monomial in rational.terms for atom, _ in monomial if name in atom.names}
    symbol, sine, cosine = Symbol(name), Call("sin", Symbol(name)), Call("cos", Symbol(name))
    if atoms == {symbol}:
        yield from _powers(rational, symbol, written)
    elif atoms <= {sine, cosine}:
        yield from _angles(rational, sine, cosine, written)


@lru_cache(maxsize=256)
def polynomial_equation(name: str, formula: Expression, value: Expression) -> Polynomial | None:
    """Return the polynomial, without square roots of a symbol, that is zero where formula = value; None if too long.

    It is cached because the same equation is solved, stated and searched for other roots.
    """
    try:
        return without_radicals((fraction(formula) + fraction(-value)).above, name)
    except OverflowError:
        return None


@dataclass(frozen=True)
class PolynomialFraction:
    """A polynomial of symbols, functions and roots over a product of polynomials, unexpanded so that factors cancel."""

    above: Polynomial
    below: tuple[Polynomial, ...] = ()

    def __add__(self, other: "PolynomialFraction") -> "PolynomialFraction":
        """Return the sum over the least common denominator."""
        mine, others = _without(self.below, other.below), _without(other.below, self.below)
        return PolynomialFraction(_times(self.above, others) + _times(other.above, mine), (*self.below, *others))

    def __mul__(self, other: "PolynomialFraction") -> "PolynomialFraction":
        """Return the product; a numerator equal to a factor of the denominator cancels."""
        above, below = _short(self.above * other.above), (*self.below, *other.below)
        if above in below:
            return PolynomialFraction(Polynomial.from_expression(1.0), _without(below, (above,)))
        return PolynomialFraction(above, below)

    def inverted(self) -> "PolynomialFraction":
        """Return the reciprocal."""
        return PolynomialFraction(
            _times(Polynomial.from_expression(1.0), self.below), () if self.above.number == 1.0 else (self.above,)
        )


@lru_cache(maxsize=2048)
def fraction(expression: Expression) -> PolynomialFraction:
    """Convert a formula to a single fraction, cached for repeated parts; OverflowError if it has too many terms."""
    match expression:
        case Number():
            return PolynomialFraction(Polynomial.from_expression(expression.x))
        case Sum():
            return reduce(add, map(fraction, expression.terms))
        case Product():
            return reduce(mul, map(fraction, expression.factors))
        case Quotient():
            above, below = fraction(expression.above), fraction(expression.below)
            shared = _without(below.below, _without(below.below, above.below))
            above, below = (PolynomialFraction(f.above, _without(f.below, shared)) for f in (above, below))
            return above * below.inverted()
        case Power() if expression.exponent > 0:
            return reduce(mul, [fraction(expression.base)] * expression.exponent)
        case _:
            return PolynomialFraction(Polynomial.from_expression(expression))


def _without(polynomials: tuple[Polynomial, ...], others: tuple[Polynomial, ...]) -> tuple[Polynomial, ...]:
    """Remove polynomials from a tuple of factors, each as often as it occurs in `others`."""
    left = list(polynomials)
    for other in others:
        if other in left:
            left.remove(other)
    return tuple(left)


def _times(polynomial: Polynomial, factors: tuple[Polynomial, ...]) -> Polynomial:
    """Multiply a polynomial by several factors; OverflowError if it gets too long."""
    for factor in factors:
        polynomial = _short(polynomial * factor)
    return polynomial


def _short(polynomial: Polynomial) -> Polynomial:
    """Return a polynomial unchanged; OverflowError if it has more terms than a solvable equation may have."""
    if len(polynomial.terms) > MAX_TERMS:
        raise OverflowError("an equation of too many terms")
    return polynomial


# ---- square roots


def without_radicals(zero: Polynomial, name: str) -> Polynomial:
    """Remove square roots of a symbol from an equation: P + Q √(a/b) = 0 becomes P² b = Q² a.

    Raises:
        OverflowError: the equation has too many roots or terms to be solved for the symbol.
    """
    radicals = {a for monomial in zero.terms for a, _ in monomial if isinstance(a, Root) and name in a.names}
    if len(radicals) > MAX_SQUARE_ROOTS or (len(radicals) > 1 and len(zero.terms) > MAX_TERMS_WITH_ROOTS):
        raise OverflowError("an equation of too many roots")
    for _ in range(MAX_SQUARE_ROOTS + 1):
        candidates = (atom for monomial in zero.terms for atom, _ in monomial if isinstance(atom, Root))
        root = next((atom for atom in candidates if name in atom.names), None)
        if root is None:
            return zero
        inside = fraction(root.inside)
        above, below = inside.above, _times(Polynomial.from_expression(1.0), inside.below)
        even, odd = Polynomial({}), Polynomial({})  # with a power of a/b for each square of the root
        highest = max(dict(monomial).get(root, 0) for monomial in zero.terms)
        for power in range(highest + 1):
            part = coefficient(zero, root, power)
            for _ in range(power // 2):
                part = _short(part * above)
            for _ in range(highest // 2 - power // 2):
                part = _short(part * below)
            even, odd = (even + part, odd) if power % 2 == 0 else (even, odd + part)
        zero = _short(_short(even * even) * below) - _short(_short(odd * odd) * above) if odd else even
    raise OverflowError("an equation of too many roots")


# ---- powers of one atom


def coefficient(polynomial: Polynomial, atom: Expression, power: int) -> Polynomial:
    """Return the coefficient of a power of an atom (a symbol, function or root) in a polynomial."""
    terms = {
        tuple(pair for pair in monomial if pair[0] != atom): part
        for monomial, part in polynomial.terms.items()
        if dict(monomial).get(atom, 0) == power
    }
    return Polynomial(terms)


def _powers(zero: Polynomial, atom: Expression, written: CoefficientWriter) -> Iterator[Expression]:
    """Yield the roots of an equation that is linear or quadratic in a symbol or function, or in its square."""
    powers = sorted({dict(monomial).get(atom, 0) for monomial in zero.terms})
    lowest, steps = powers[0], [power - powers[0] for power in powers]
    step = 2 if all(power % 2 == 0 for power in steps) and max(steps) > MAX_DEGREE else 1
    if max(steps) > MAX_DEGREE * step:
        return
    rest, linear, square = (coefficient(zero, atom, lowest + step * n) for n in range(MAX_DEGREE + 1))
    for root in _quadratic(rest, linear, square, written):
        yield from [root] if step == 1 else [Root(root), -Root(root)]


def _quadratic(
    rest: Polynomial, linear: Polynomial, square: Polynomial, written: CoefficientWriter
) -> Iterator[Expression]:
    """Yield the roots x of rest + linear · x + square · x² = 0."""
    if not square:
        if linear:
            yield _over(rest.scale(-1.0), linear, written)
        return
    if not linear:
        size = Root(_over(rest.scale(-1.0), square, written))
        yield from (size, -size)
        return
    shared = common_monomial([*rest.terms, *linear.terms, *square.terms])
    rest, linear, square = (divide_by_term(part, shared, 1.0) or part for part in (rest, linear, square))
    if written(square).negative:
        rest, linear, square = (part.scale(-1.0) for part in (rest, linear, square))
    if all(abs(part) == 0.5 for part in square.terms.values()):  # 2 (½ b − √…)/a is (b − √…)/a
        rest, linear, square = (part.scale(2.0) for part in (rest, linear, square))
    if written is Polynomial.factored and all(
        part % 2.0 == 1.0 for part in linear.terms.values()
    ):  # for (−b + √(b² − 4 a c))/(2 a)
        rest, linear, square = (part.scale(2.0) for part in (rest, linear, square))
    half = linear.scale(0.5)
    root = Root(written(half * half - square * rest))
    for sign in (1.0, -1.0):
        yield ratio(sum_terms(written(half.scale(-1.0)), multiply_factors(Number(sign), root)), written(square))


def _over(above: Polynomial, below: Polynomial, written: CoefficientWriter) -> Expression:
    """Return the quotient of two polynomials with common factors cancelled."""
    return reduced_quotient(above, below) if written is Polynomial.factored else ratio(written(above), written(below))


# ---- angles


def _angles(zero: Polynomial, sine: Call, cosine: Call, written: CoefficientWriter) -> Iterator[Expression]:
    """Yield the roots of an equation in sin x or cos x alone, linear in both, or of second degree in both."""
    pairs = {_degrees(monomial, sine, cosine) for monomial in zero.terms}
    alone: tuple[tuple[Call, Function, int], ...] = ((sine, "arcsin", 1), (cosine, "arccos", 0))
    for atom, inverse, other in alone:
        if all(pair[other] == 0 for pair in pairs):
            yield from (Call(inverse, root) for root in _powers(zero, atom, written))
            return
    rest = _constant(zero, sine, cosine)
    if all(sum(pair) <= 1 for pair in pairs):
        yield from _linear(coefficient(zero, sine, 1), coefficient(zero, cosine, 1), rest, written)
    elif all(sum(pair) in (0, MAX_DEGREE) for pair in pairs):
        first = coefficient(coefficient(zero, sine, 2), cosine, 0).scale(0.5)
        second = coefficient(coefficient(zero, cosine, 2), sine, 0).scale(0.5)
        mixed = coefficient(coefficient(zero, sine, 1), cosine, 1).scale(0.5)
        for double in _linear(mixed, second - first, rest + first + second, written):
            yield ratio(double, Number(2.0))  # sin² = (1 − cos 2x)/2, 2 sin cos = sin 2x


def _degrees(monomial: Monomial, sine: Call, cosine: Call) -> tuple[int, int]:
    """Return the exponents of the sine and the cosine in a monomial."""
    powers = dict(monomial)
    return powers.get(sine, 0), powers.get(cosine, 0)


def _constant(zero: Polynomial, sine: Call, cosine: Call) -> Polynomial:
    """Return the terms of a polynomial that contain neither the sine nor the cosine."""
    return coefficient(coefficient(zero, sine, 0), cosine, 0)


def _linear(a: Polynomial, b: Polynomial, rest: Polynomial, written: CoefficientWriter) -> Iterator[Expression]:
    """Yield the roots of a sin x + b cos x + c = 0: x = arcsin(−c/√(a² + b²)) − arctan(b/a), or with π − arcsin."""
    if not a:
        if b:
            yield Call("arccos", _over(rest.scale(-1.0), b, written))
        return
    if sum(a.terms.values()) < 0.0:
        a, b, rest = (part.scale(-1.0) for part in (a, b, rest))
    turn: Expression = Call("arctan", _over(b, a, written)) if b else ZERO
    if not rest:
        yield -turn
        return
    for size in _sizes(a, b, written):
        inverse = Call("arcsin", ratio(written(rest.scale(-1.0)), size))
        yield from (sum_terms(inverse, -turn), sum_terms(sum_terms(PI, -inverse), -turn))


def _sizes(a: Polynomial, b: Polynomial, written: CoefficientWriter) -> Iterator[Expression]:
    """Yield forms of √(a² + b²): first those with positive common factors taken out of the root."""
    shares = cancel_common_sum(b, a) if b and written is Polynomial.factored else None
    if shares is not None:  # b/a is a single term, or one over it
        above, below = shares
        outer, rest = (a, above) if below.number is not None else (b, below)
        yield multiply_factors(written(outer), Root(written(Polynomial.from_expression(1.0) + rest * rest)))
    shared = common_monomial([*a.terms, *b.terms]) if b and written is Polynomial.factored else ()
    parts = [divide_by_term(item, shared, 1.0) for item in (a, b)] if shared else []
    if parts and None not in parts:
        one, other = (part for part in parts if part is not None)
        yield multiply_factors(
            reduce(multiply_factors, (power_of(*item) for item in shared)), Root(written(one * one + other * other))
        )
    yield Root(written(a * a + b * b)) if b else written(a)


def power_of(atom: Expression, power: int) -> Expression:
    """Return an integer power of an expression; the expression itself if the exponent is one."""
    return atom if power == 1 else Power(atom, power)


@lru_cache(maxsize=4096)
def expand_numbers(expression: Expression, name: str) -> Expression:
    """Replace rounded numbers whose formulas contain a symbol by those formulas, cached for repeated parts."""
    if isinstance(expression, NumericFormula):
        return expand_numbers(expression.inner, name) if name in expression.names else expression
    if name not in expression.names or not expression.parts:
        return expression
    return expression.built_of([expand_numbers(part, name) for part in expression.parts])
