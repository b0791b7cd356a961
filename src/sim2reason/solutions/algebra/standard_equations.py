"""Equations in standard form, and closed-form roots of equations in a single sine or a monotonic function."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import lru_cache, reduce
from itertools import pairwise
from math import pi
from operator import mul

import numpy as np

from sim2reason.scenes.dsl.state import Array
from sim2reason.solutions.algebra.closed_roots import (
    CoefficientWriter,
    PolynomialFraction,
    coefficient,
    expand_numbers,
    fraction,
    polynomial_equation,
    power_of,
)
from sim2reason.solutions.algebra.evaluated import Chain, ClosedRoot, NumericRoot
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
    ratio,
    sum_terms,
)
from sim2reason.solutions.algebra.fractions import reduced_quotient
from sim2reason.solutions.algebra.functions import Call, Power, Root, sum_formulas
from sim2reason.solutions.algebra.polynomials import Polynomial, common_monomial, divide_by_term
from sim2reason.solutions.algebra.root_finding import solved_for
from sim2reason.solutions.solution import with_unit
from sim2reason.solutions.writing.notation import DEGREES


def stated_equation(
    name: str, formula: Expression, value: Expression, written: CoefficientWriter
) -> tuple[Expression, Expression] | None:
    """Reduce an equation to a x² + b x = c or a sin x + b cos x = c; return both sides, or None if it is neither.

    In the first form, x may also be the sine or the cosine of the symbol.
    """
    zero = polynomial_equation(name, expand_numbers(formula, name), value)
    if zero is None:
        return None
    zero = divide_by_term(zero, common_monomial([*zero.terms]), 1.0) or zero
    symbol, sine, cosine = Symbol(name), Call("sin", Symbol(name)), Call("cos", Symbol(name))
    squares = ((atom, atom, (2, 1)) for atom in (symbol, sine, cosine))
    for first, second, powers in (*squares, (sine, cosine, (1, 1))):
        parts = [coefficient(zero, atom, power) for atom, power in zip((first, second), powers, strict=True)]
        rest = zero
        for part, atom, power in zip(parts, (first, second), powers, strict=True):
            rest = rest - part * Polynomial({((atom, power),): 1.0})
        if not all(parts) or name in rest.names() or any(name in p.names() for p in parts):
            continue
        sign = -1.0 if written(parts[0]).negative else 1.0
        terms = (
            multiply_factors(written(part.scale(sign)), power_of(atom, power))
            for part, atom, power in zip(parts, (first, second), powers, strict=True)
        )
        return reduce(sum_terms, terms), written(rest.scale(-sign))
    return None


def as_one_fraction(formula: Expression, name: str, *, always: bool = False) -> Expression:
    """Return a formula of a symbol as one fraction if that is shorter; a square root keeps the fraction under it.

    With `always` it is one fraction of any length, with the common number of all terms in front.
    """
    if isinstance(formula, Root):
        return Root(as_one_fraction(formula.inside, name))
    plain = _without_squared_roots(formula)
    try:
        combined = reduced_quotient(*_sides(fraction(expand_numbers(plain, name))), grouped=always)
    except OverflowError:
        return plain
    again = _without_squared_roots(combined)  # squares of roots may appear once other terms have cancelled
    combined = as_one_fraction(again, name) if again != combined else combined
    return combined if always or len(combined.latex()) < len(plain.latex()) else plain


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
    return multiply_factors(worked(reduced_quotient(rest, below)), power_of(Symbol(name), power))


def found_by_double_angle(formula: Expression, solution: Expression, name: str) -> bool:
    """Return whether an angle is found as half of a double angle, from the squares of its sine and cosine."""
    squares = {Power(Call(function, Symbol(name)), 2) for function in ("sin", "cos")}
    halved = isinstance(solution, Quotient) and solution.below == Number(2.0)
    return halved and any(part in squares for part in _subexpressions(formula))


def half_angles(name: str) -> list[tuple[Expression, Expression]]:
    """Return the half-angle formulas: pairs of cos² or sin² of an angle and its value by the double angle."""
    twice = Call("cos", multiply_factors(Number(2.0), Symbol(name)))
    halves = (sum_terms(ONE, twice), sum_terms(ONE, -twice))
    squares = (Power(Call("cos", Symbol(name)), 2), Power(Call("sin", Symbol(name)), 2))
    return [(square, multiply_factors(Number(0.5), half)) for square, half in zip(squares, halves, strict=True)]


def _subexpressions(held: Expression) -> Iterator[Expression]:
    """Yield a formula and all of its subexpressions."""
    yield held
    for part in held.parts:
        yield from _subexpressions(part)


@lru_cache(maxsize=4096)
def _without_squared_roots(expression: Expression) -> Expression:
    """Replace squares of square roots by their radicands, cached for repeated parts."""
    if not expression.parts:
        return expression
    expression = expression.built_of([_without_squared_roots(part) for part in expression.parts])
    if not isinstance(expression, Power) or expression.exponent < 0 or expression.exponent % 2:
        return expression
    factors = expression.base.factors if isinstance(expression.base, Product) else (expression.base,)
    if not any(isinstance(factor, Root) for factor in factors):
        return expression
    half = expression.exponent // 2
    squared = (power_of(f.inside, half) if isinstance(f, Root) else Power(f, expression.exponent) for f in factors)
    return reduce(multiply_factors, squared)


def _sides(quotient: PolynomialFraction) -> tuple[Polynomial, Polynomial]:
    """Return the numerator and the expanded denominator of a fraction."""
    return quotient.above, reduce(mul, quotient.below, Polynomial.from_expression(1.0))


SAMPLE_WINDOWS = (
    (0.3, 3.0),
    (0.7, 1.4),
)  # ranges relative to the unknown; the second if formulas are undefined in the first
SAMPLE_COUNT = 14  # samples in a range
SINGULAR_VALUE_RTOL = 1e-11  # relative: largest singular value that counts as zero
VISIBLE_TERM_RATIO = 1e-9  # relative to the largest term: smaller ones are left out of a stated equation
COEFFICIENT_RTOL = 1e-13  # relative to the largest coefficient: smaller ones are rounding errors

Basis = Sequence[Expression]
Parts = tuple[Array, Array]
"""The coefficients of two sums of the functions of a basis: numerator and denominator."""


def closed_root(chain: Chain, at: Symbol, unknown: str, values: Mapping[str, float]) -> ClosedRoot | None:
    """Return the closed form of an unknown for which a chain of formulas equals the symbol `at`; None if not found."""
    target, near = values[at.name], values[unknown]
    for power, basis, (above, below), _ in _fractions(chain, unknown, values):
        coefficients = above - target**power * below
        coefficients = coefficients / np.abs(coefficients).max()
        equation = _summed(basis, coefficients, np.abs(coefficients) > COEFFICIENT_RTOL)
        closed = solved_for(unknown, equation, ZERO, {unknown: near})
        if not isinstance(closed, NumericRoot):
            return ClosedRoot(sum_terms(chain, -at), unknown, near, equation, closed)
    return None


def fraction_in(chain: Chain, at: Symbol, unknown: str, values: Mapping[str, float]) -> tuple[Expression, Expression]:
    """Return both sides of the equation of a chain of formulas: `at` or its square, and a fraction of sums."""
    for power, basis, parts, points in _fractions(chain, unknown, values):
        sizes = np.array(
            [max(abs(basis_function.value({unknown: x})) for x in points.tolist()) for basis_function in basis]
        )
        scaled = [part / _largest(parts[1]) for part in parts]
        above, below = (_summed(basis, part, _is_shown(np.abs(part * sizes))) for part in scaled)
        return Power(at, power) if power > 1 else at, ratio(above, below)
    raise ValueError("the chain is no fraction of such sums")


def _fractions(chain: Chain, unknown: str, values: Mapping[str, float]) -> Iterator[tuple[int, Basis, Parts, Array]]:
    """Yield the fractions of linear combinations of functions that reproduce a chain, or its square, at sample points.

    Each item has the power of the chain, the functions, the coefficients of both sums, and the sample points.
    """
    seen = _sampled(chain, unknown, values)
    if seen is None:
        return
    for power in (1, 2):  # the square of a speed may be simple where the speed is not
        for basis in _bases(Symbol(unknown)):
            if (parts := _fitted_coefficients(seen, basis, unknown, power)) is not None:
                yield power, basis, parts, seen[0]


def _bases(x: Symbol) -> Iterator[Basis]:
    """Yield sets of functions of the unknown whose linear combinations may be numerator and denominator."""
    yield ONE, x
    yield ONE, Call("sin", x), Call("cos", x)
    yield ONE, x, Power(x, 2)


def _sampled(chain: Chain, unknown: str, values: Mapping[str, float]) -> tuple[Array, Array] | None:
    """Return sample points near the unknown's value and the chain's values there; None if it is undefined."""
    for first, last in SAMPLE_WINDOWS:
        points = values[unknown] * np.geomspace(first, last, SAMPLE_COUNT)
        try:
            samples = [chain.value({**values, unknown: x}) for x in points.tolist()]
        except (ValueError, ArithmeticError):
            continue
        if all(isinstance(value, float) for value in samples):
            return points, np.array(samples)
    return None


def _summed(basis: Basis, parts: Array, kept: Array) -> Expression:
    """Return the sum of functions times coefficients, without the terms that are not `kept`."""
    return sum_formulas(
        Number(part) * basis_function
        for basis_function, part, keeps in zip(basis, parts.tolist(), kept, strict=True)
        if keeps
    )


def _is_shown(terms: Array) -> Array:
    """Return a mask of the terms of a sum, given by their magnitudes, that are large enough to be written."""
    return terms > VISIBLE_TERM_RATIO * terms.max()


def _largest(parts: Array) -> float:
    """Return the coefficient of largest magnitude."""
    return float(parts[np.abs(parts).argmax()])


def _fitted_coefficients(seen: tuple[Array, Array], basis: Basis, unknown: str, power: int) -> Parts | None:
    """Return the coefficients of the numerator and denominator whose quotient fits the samples; None if none does."""
    points, values = seen
    columns = np.array([[held.value({unknown: x}) for held in basis] for x in points.tolist()])
    whole = np.hstack([columns, -(values**power)[:, None] * columns])
    sizes = np.abs(whole).max(axis=0)
    if not np.all(np.isfinite(whole)) or np.any(sizes == 0.0):
        return None
    _, singular, rows = np.linalg.svd(whole / sizes)
    if singular[-1] > SINGULAR_VALUE_RTOL * singular[0] or singular[-2] <= SINGULAR_VALUE_RTOL * singular[0]:
        return None
    above, below = np.split(rows[-1] / sizes, 2)
    return above, below


SPAN, SAMPLES, MIN_TREND_SAMPLES = (
    1e3,
    160,
    20,
)  # ratio of largest value to the known one; samples; least number of defined ones


def trend(formula: Expression, name: str, values: Mapping[str, float]) -> str:
    """Return ``increases`` or ``decreases`` if a formula is monotonic in a symbol at all samples, else "".

    Samples have the sign of the symbol's value; the formula may be undefined at some of them.
    """
    samples: list[float] = []
    for argument in (values[name] * np.geomspace(1.0 / SPAN, SPAN, SAMPLES)).tolist():
        try:
            value = formula.value({**values, name: argument})
        except (ValueError, ArithmeticError):
            continue
        if isinstance(value, float):
            samples.append(value)
    steps = [after - before for before, after in pairwise(samples)]
    if len(steps) < MIN_TREND_SAMPLES or values[name] <= 0.0:
        return ""
    if all(step > 0.0 for step in steps):
        return "increases"
    return "decreases" if all(step < 0.0 for step in steps) else ""


def single_sine(name: str, solution: Expression) -> str:
    """Return a clause: a sin x + b cos x is a multiple of one sine, if x is arcsin(…) ± arctan(…); else ""."""
    if not isinstance(solution, Sum) or len(solution.terms) != 2:
        return ""
    signed = {pair[1].function: pair for term in solution.terms if (pair := _signed(term)) is not None}
    if signed.keys() != {"arcsin", "arctan"}:
        return ""
    sign, inner = signed["arctan"]
    argument = inner.argument
    if argument.negative:
        sign, argument = -sign, -argument
    turn = Call("arctan", argument).latex()
    return rf"The left side is a multiple of $\sin\left({name} {'-' if sign > 0.0 else '+'} {turn}\right)$"


def beyond_right_angle(others: Sequence[float], value: float) -> str:
    """Return the sentence that the only other solution for an angle exceeds 90°; "" if it does not."""
    if len(others) != 1 or not 0.0 < value <= 0.5 * pi < others[0]:
        return ""
    return f"The other solution, ${with_unit(others[0], DEGREES)}$, is more than $90^\\circ$."


def _signed(term: Expression) -> tuple[float, Call] | None:
    """Return the sign and the function of a term ± f(…); None for other terms."""
    match term:
        case Call():
            return 1.0, term
        case Product((Number(-1.0), Call() as inner)):
            return -1.0, inner
        case _:
            return None
