"""Equations solved for one symbol: by inverse operations, as polynomials, or numerically."""

from collections.abc import Callable, Iterator, Mapping
from functools import reduce

from sim2reason.solutions.algebra.closed_roots import CoefficientWriter, expand_numbers, fraction, roots
from sim2reason.solutions.algebra.evaluated import NumericFormula, NumericRoot, numeric_parts
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
from sim2reason.solutions.algebra.functions import Call, Function, Power, Root
from sim2reason.solutions.algebra.polynomials import Polynomial

BRANCH_RTOL = 1e-6  # relative: largest difference between a root and the known value
INVERSE_FUNCTIONS: dict[str, Function] = {
    "sin": "arcsin",
    "cos": "arccos",
    "tan": "arctan",
    "arcsin": "sin",
    "arccos": "cos",
    "arctan": "tan",
    "ln": "exp",
    "exp": "ln",
}


def solved_for(
    name: str,
    formula: Expression,
    value: Expression,
    at: Mapping[str, float],
    written: CoefficientWriter = Polynomial.factored,
) -> Expression:
    """Solve formula = value for a symbol; among several branches, choose the one with the known value in `at`.

    `written` converts the coefficients of a quadratic equation to formulas.
    """
    for held in _branches(name, formula, value, written):
        found = _real(held, at)
        if found is not None and abs(found - at[name]) <= BRANCH_RTOL * abs(at[name]):
            return held
    return numeric_root(name, formula, value, at)


def other_solutions(name: str, formula: Expression, value: Expression, at: Mapping[str, float]) -> list[float]:
    """Return the other values of a symbol that solve formula = value, besides its known value in `at`."""
    found: list[float] = []
    for held in _branches(name, formula, value, Polynomial.factored):
        other = _real(held, at)
        if other is None or any(abs(other - known) <= BRANCH_RTOL * abs(known) for known in (at[name], *found)):
            continue
        reached, wanted = (_real(side, {**at, name: other}) for side in (formula, value))
        if reached is None or wanted is None:
            continue
        if abs(reached - wanted) <= BRANCH_RTOL * (abs(wanted) or max(1.0, other**2)):
            found.append(other)
    return found


def numeric_root(name: str, formula: Expression, value: Expression, at: Mapping[str, float]) -> NumericRoot:
    """Return the root of formula = value, by Newton's method near the known value of a symbol."""
    return NumericRoot(added(formula, -value), name, at[name])


def substitute(held: Expression, name: str, formula: Expression) -> Expression:
    """Substitute a formula for a symbol."""
    if name not in held.symbols():
        return held
    if isinstance(held, Symbol):
        return formula
    if isinstance(held, NumericFormula):
        return substitute(held.inner, name, formula)
    if not held.parts:
        raise TypeError(f"{type(held).__name__} holds no symbol that could be replaced")
    return held.built_of([substitute(part, name, formula) for part in held.parts])


def substitute_all(held: Expression, formulas: Mapping[str, Expression]) -> Expression:
    """Substitute formulas for symbols, one after the other."""
    return reduce(lambda whole, pair: substitute(whole, *pair), formulas.items(), held)


def evaluate_known_parts(
    held: Expression, unknown: frozenset[str], worked: Callable[[Expression], Expression]
) -> Expression:
    """Replace the parts of a formula without unknowns by numbers, unless each of them is a single symbol."""
    found = _Settling(unknown, worked).of(held)
    return _without_symbols(found, unknown, worked) if next(numeric_parts(found), None) is not None else found


def _without_symbols(
    held: Expression, unknown: frozenset[str], worked: Callable[[Expression], Expression]
) -> Expression:
    """Replace known symbols by their values and put numbers first in products, as in 3.2 v."""
    if isinstance(held, Symbol):
        return held if held.name in unknown else worked(held)
    if not held.parts or isinstance(held, NumericFormula):
        return held
    parts = [_without_symbols(part, unknown, worked) for part in held.parts]
    if isinstance(held, Product):
        parts.sort(key=lambda part: not isinstance(part, NumericFormula))
    return held.built_of(parts)


class _Settling:
    """A replacement of the known parts of formulas by numbers; repeated parts are visited once."""

    def __init__(self, unknown: frozenset[str], worked: Callable[[Expression], Expression]) -> None:
        self._unknown, self._worked = unknown, worked
        self._open: dict[int, bool] = {}  # by id of parts; the whole formula keeps them alive
        self._found: dict[int, Expression] = {}

    def of(self, held: Expression) -> Expression:
        """Return a formula with its known parts replaced by numbers."""
        if id(held) not in self._found:
            self._found[id(held)] = self._settled(held)
        return self._found[id(held)]

    def _settled(self, held: Expression) -> Expression:
        """Return a formula with its known parts replaced by numbers, without the cache."""
        if not self._is_open(held):
            return held if isinstance(held, Number | Symbol | NumericFormula) else self._worked(held)
        if not held.parts or isinstance(held, NumericFormula):
            return held
        if isinstance(held, Sum | Product):
            known = [part for part in held.parts if not self._is_open(part)]
            if len(known) > 1:
                rest = [self.of(part) for part in held.parts if self._is_open(part)]
                return held.built_of([self._worked(held.built_of(known)), *rest])
        return held.built_of([self.of(part) for part in held.parts])

    def _is_open(self, held: Expression) -> bool:
        """Return whether a part of a formula contains an unknown."""
        if id(held) not in self._open:
            parts = held.parts
            names = () if parts else held.symbols()
            self._open[id(held)] = any(map(self._is_open, parts)) or not self._unknown.isdisjoint(names)
        return self._open[id(held)]


def _real(held: Expression, at: Mapping[str, float]) -> float | None:
    """Return the real value of a formula; None if it is undefined or complex."""
    try:
        found = held.value(at)
    except (ValueError, ZeroDivisionError, OverflowError):
        return None
    return None if isinstance(found, complex) else found


def _branches(name: str, formula: Expression, value: Expression, written: CoefficientWriter) -> Iterator[Expression]:
    """Yield all closed-form solutions of formula = value for a symbol."""
    formula = expand_numbers(formula, name)
    if formula == Symbol(name):
        yield value
        return
    inside = [part for part in formula.parts if name in part.symbols()]
    if len(inside) == 1:
        for rest in _undone(formula, inside[0], value):
            yield from _branches(name, inside[0], rest, written)
    else:
        yield from _roots(name, formula, value, written)


def _undone(formula: Expression, part: Expression, value: Expression) -> Iterator[Expression]:
    """Yield what one operand must equal so that formula = value, by the inverse of the outermost operation."""
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
            root = value.base if isinstance(value, Power) and value.exponent == 2 else Root(value)
            yield from (root, -root)
        case Root():
            yield Power(value, 2)
        case Call():
            yield Call(INVERSE_FUNCTIONS[formula.function], value)
        case _:
            return


def _roots(name: str, formula: Expression, value: Expression, written: CoefficientWriter) -> Iterator[Expression]:
    """Yield the closed-form solutions for a symbol that occurs several times in an equation."""
    try:
        zero = fraction(formula) + fraction(-value)
    except OverflowError:
        return
    yield from roots(name, zero.above, written)
