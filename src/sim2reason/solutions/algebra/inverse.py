"""Equations solved for one symbol: by undoing what was done to it, as a polynomial in it, or numerically."""

from collections.abc import Iterable, Iterator, Mapping
from functools import reduce

from sim2reason.solutions.algebra.elimination import solved
from sim2reason.solutions.algebra.evaluated import NumericRoot, Worked
from sim2reason.solutions.algebra.expressions import (
    ZERO,
    Expression,
    Number,
    Product,
    Quotient,
    Sum,
    Symbol,
    added,
    multiplied,
    ratio,
)
from sim2reason.solutions.algebra.fractions import over
from sim2reason.solutions.algebra.functions import Call, Function, Power, Root
from sim2reason.solutions.algebra.polynomials import Polynomial

MOST = 40  # terms of an equation that is solved in symbols
NEAR = 1e-6  # relative: how well a branch must meet the value that is known
UNDONE: dict[str, Function] = {
    "sin": "arcsin",
    "cos": "arccos",
    "tan": "arctan",
    "arcsin": "sin",
    "arccos": "cos",
    "arctan": "tan",
    "ln": "exp",
    "exp": "ln",
}


def solved_for(name: str, formula: Expression, value: Expression, at: Mapping[str, float]) -> Expression:
    """What a symbol is where a formula of it has a value; of several branches, that which is so `at` known values."""
    for held in _branches(name, formula, value, at):
        found = _real(held, at)
        if found is not None and abs(found - at[name]) <= NEAR * abs(at[name]):
            return held
    return numeric_root(name, formula, value, at)


def numeric_root(name: str, formula: Expression, value: Expression, at: Mapping[str, float]) -> NumericRoot:
    """The same, found numerically near where it is known to be."""
    return NumericRoot(added(formula, -value), name, at[name])


def put(held: Expression, name: str, formula: Expression) -> Expression:
    """A formula with another one in place of a symbol."""
    if name not in held.symbols():
        return held
    if isinstance(held, Symbol):
        return formula
    if isinstance(held, Worked):
        return put(held.inner, name, formula)
    if not held.parts:
        raise TypeError(f"{type(held).__name__} holds no symbol that could be replaced")
    return held.built_of([put(part, name, formula) for part in held.parts])


def _real(held: Expression, at: Mapping[str, float]) -> float | None:
    try:
        found = held.value(at)
    except (ValueError, ZeroDivisionError, OverflowError):
        return None
    return None if isinstance(found, complex) else found


def _branches(name: str, formula: Expression, value: Expression, at: Mapping[str, float]) -> Iterator[Expression]:
    """All that a symbol may be."""
    if isinstance(formula, Worked):
        formula = formula.inner
    if formula == Symbol(name):
        yield value
        return
    inside = [part for part in formula.parts if name in part.symbols()]
    if len(inside) == 1:
        for rest in _undone(formula, inside[0], value):
            yield from _branches(name, inside[0], rest, at)
    else:
        yield from _roots(name, formula, value)


def _undone(formula: Expression, part: Expression, value: Expression) -> Iterator[Expression]:
    """What a part of a formula must be, the rest of which is known."""
    match formula:
        case Sum():
            yield reduce(added, (-term for term in formula.terms if term is not part), value)
        case Product():
            rest = reduce(multiplied, (factor for factor in formula.factors if factor is not part))
            yield ratio(value, rest)
        case Quotient() if part is formula.above:
            yield multiplied(value, formula.below)
        case Quotient() if value != ZERO:
            yield ratio(formula.above, value)
        case Power() if formula.exponent == 2:
            yield from (Root(value), -Root(value))
        case Root():
            yield Power(value, 2)
        case Call():
            yield Call(UNDONE[formula.function], value)
        case _:
            return


def _roots(name: str, formula: Expression, value: Expression) -> Iterator[Expression]:
    """Of an equation that is linear or quadratic in a symbol, or linear in the sine and cosine of an angle."""
    try:
        (above, below), (over, under) = fraction(formula), fraction(value)
    except OverflowError:
        return
    zero = above * under - over * below
    sine, cosine = Call("sin", Symbol(name)), Call("cos", Symbol(name))
    if any(atom in (sine, cosine) for monomial in zero.terms for atom, _ in monomial):
        yield from _angles(zero, sine, cosine)
        return
    parts = [_coefficient(zero, Symbol(name), power) for power in range(3)]
    if any(name in part.names() for part in parts) or len(zero.terms) != sum(len(part.terms) for part in parts):
        return
    rest, linear, square = parts
    if not square:
        yield from [solved(zero, name)] if linear else []
        return
    half = linear.scaled(0.5)
    root = Root((half * half - square * rest).factored())
    for sign in (1.0, -1.0):
        above = added(half.scaled(-1.0).factored(), multiplied(Number(sign), root))
        yield ratio(above, square.factored())


def _angles(zero: Polynomial, sine: Call, cosine: Call) -> Iterator[Expression]:
    """Of a sin x + b cos x = c: x = arcsin(c/√(a² + b²)) − arctan(b/a), or arctan(−b/a) where c is zero."""
    a, b = _coefficient(zero, sine, 1), _coefficient(zero, cosine, 1)
    rest = Polynomial({m: p for m, p in zero.terms.items() if all(atom not in (sine, cosine) for atom, _ in m)})
    whole = len(a.terms) + len(b.terms) + len(rest.terms)
    tangled = any(sine.argument.latex() in part.names() for part in (a, b, rest))
    if whole != len(zero.terms) or tangled or not a:
        return
    if sum(a.terms.values()) < 0.0:
        a, b, rest = a.scaled(-1.0), b.scaled(-1.0), rest.scaled(-1.0)
    turn = Call("arctan", over(b, a)) if b else ZERO
    if not rest:
        yield -turn
        return
    if not b:
        yield Call("arcsin", over(rest.scaled(-1.0), a))
        return
    yield added(Call("arcsin", ratio(rest.scaled(-1.0).factored(), Root((a * a + b * b).factored()))), -turn)


def _coefficient(held: Polynomial, atom: Expression, power: int) -> Polynomial:
    """What stands before a power of an atom."""
    found = {
        tuple(pair for pair in monomial if pair[0] != atom): part
        for monomial, part in held.terms.items()
        if dict(monomial).get(atom, 0) == power
    }
    return Polynomial(found)


def fraction(held: Expression) -> tuple[Polynomial, Polynomial]:
    """Numerator and denominator, as polynomials of symbols, functions and roots; OverflowError if they are long."""
    one = Polynomial.of(1.0)
    match held:
        case Number():
            found = Polynomial.of(held.x), one
        case Worked():
            found = fraction(held.inner)
        case Sum():
            found = Polynomial({}), one
            for a, b in map(fraction, held.terms):
                found = (found[0] + a, b) if b == found[1] else (found[0] * b + a * found[1], found[1] * b)
        case Product():
            found = _product(map(fraction, held.factors))
        case Quotient():
            (a, b), (c, d) = fraction(held.above), fraction(held.below)
            found = a * d, b * c
        case Power() if held.exponent > 0:
            found = _product([fraction(held.base)] * held.exponent)
        case _:
            found = Polynomial.of(held), one
    if max(len(part.terms) for part in found) > MOST:
        raise OverflowError("an equation of too many terms")
    return found


def _product(parts: Iterable[tuple[Polynomial, Polynomial]]) -> tuple[Polynomial, Polynomial]:
    above, below = Polynomial.of(1.0), Polynomial.of(1.0)
    for a, b in parts:
        above, below = above * a, below * b
        if max(len(above.terms), len(below.terms)) > MOST:
            raise OverflowError("an equation of too many terms")
    return above, below
