"""Equations solved for one symbol: by inverse operations, as polynomials, or by a numerical search for roots."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import reduce
from math import isfinite, pi

import numpy as np

from sim2reason.solutions.algebra.closed_roots import CoefficientWriter, expand_numbers, roots
from sim2reason.solutions.algebra.evaluated import Chain, ImplicitRoot, NumericFormula, NumericRoot, numeric_parts
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
from sim2reason.solutions.algebra.functions import Call, Function, Power, Root
from sim2reason.solutions.algebra.known_values import with_known_values
from sim2reason.solutions.algebra.polynomials import Polynomial
from sim2reason.solutions.setting import join_words
from sim2reason.solutions.writing.notation import DEGREES
from sim2reason.solutions.writing.steps import SolutionBuilder, StepBuilder

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
    for branch in _branches(name, formula, value, written):
        solution = _real(branch, at)
        if solution is not None and abs(solution - at[name]) <= BRANCH_RTOL * abs(at[name]):
            return branch
    return numeric_root(name, formula, value, at)


def other_solutions(name: str, formula: Expression, value: Expression, at: Mapping[str, float]) -> list[float]:
    """Return the other values of a symbol that solve formula = value, besides its known value in `at`."""
    solutions: list[float] = []
    for branch in _branches(name, formula, value, Polynomial.factored):
        other = _real(branch, at)
        if other is None or any(abs(other - known) <= BRANCH_RTOL * abs(known) for known in (at[name], *solutions)):
            continue
        reached, wanted = (_real(side, {**at, name: other}) for side in (formula, value))
        if reached is None or wanted is None:
            continue
        if abs(reached - wanted) <= BRANCH_RTOL * (abs(wanted) or max(1.0, other**2)):
            solutions.append(other)
    return solutions


def numeric_root(name: str, formula: Expression, value: Expression, at: Mapping[str, float]) -> NumericRoot:
    """Return the root of formula = value, by Newton's method near the known value of a symbol."""
    return NumericRoot(sum_terms(formula, -value), name, at[name])


def substitute(expression: Expression, name: str, formula: Expression) -> Expression:
    """Substitute a formula for a symbol."""
    if name not in expression.names:
        return expression
    if isinstance(expression, Symbol):
        return formula
    if isinstance(expression, NumericFormula):
        return substitute(expression.inner, name, formula)
    if not expression.parts:
        raise TypeError(f"{type(expression).__name__} holds no symbol that could be replaced")
    return expression.built_of([substitute(part, name, formula) for part in expression.parts])


def substitute_all(expression: Expression, formulas: Mapping[str, Expression]) -> Expression:
    """Substitute formulas for symbols, one after the other."""
    return reduce(lambda current, pair: substitute(current, *pair), formulas.items(), expression)


def evaluate_known_parts(
    expression: Expression, unknown: frozenset[str], worked: Callable[[Expression], Expression]
) -> Expression:
    """Replace the parts of a formula without unknowns by numbers, unless each of them is a single symbol."""
    evaluated = _Settling(unknown, worked).evaluate(expression)
    return (
        _without_symbols(evaluated, unknown, worked) if next(numeric_parts(evaluated), None) is not None else evaluated
    )


def _without_symbols(
    expression: Expression, unknown: frozenset[str], worked: Callable[[Expression], Expression]
) -> Expression:
    """Replace known symbols by their values and put numbers first in products, as in 3.2 v."""
    if isinstance(expression, Symbol):
        return expression if expression.name in unknown else worked(expression)
    if not expression.parts or isinstance(expression, NumericFormula):
        return expression
    parts = [_without_symbols(part, unknown, worked) for part in expression.parts]
    if isinstance(expression, Product):
        parts.sort(key=lambda part: not isinstance(part, NumericFormula))
    return expression.built_of(parts)


class _Settling:
    """A replacement of the known parts of formulas by numbers; repeated parts are visited once."""

    def __init__(self, unknown: frozenset[str], worked: Callable[[Expression], Expression]) -> None:
        self._unknown, self._worked = unknown, worked
        self._open: dict[int, bool] = {}  # by id of parts; the whole formula keeps them alive
        self._found: dict[int, Expression] = {}

    def evaluate(self, held: Expression) -> Expression:
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
                rest = [self.evaluate(part) for part in held.parts if self._is_open(part)]
                return held.built_of([self._worked(held.built_of(known)), *rest])
        return held.built_of([self.evaluate(part) for part in held.parts])

    def _is_open(self, held: Expression) -> bool:
        """Return whether a part of a formula contains an unknown."""
        if id(held) not in self._open:
            parts = held.parts
            names = () if parts else held.symbols()
            self._open[id(held)] = any(map(self._is_open, parts)) or not self._unknown.isdisjoint(names)
        return self._open[id(held)]


def _real(expression: Expression, at: Mapping[str, float]) -> float | None:
    """Return the real value of a formula; None if it is undefined or complex."""
    try:
        value = expression.value(at)
    except (ValueError, ZeroDivisionError, OverflowError):
        return None
    return None if isinstance(value, complex) else value


def _branches(name: str, formula: Expression, value: Expression, written: CoefficientWriter) -> Iterator[Expression]:
    """Yield all closed-form solutions of formula = value for a symbol."""
    formula = expand_numbers(formula, name)
    if formula == Symbol(name):
        yield value
        return
    inside = [part for part in formula.parts if name in part.names]
    if len(inside) == 1:
        for rest in _undone(formula, inside[0], value):
            yield from _branches(name, inside[0], rest, written)
    else:
        yield from roots(name, formula, value, written)


def _undone(formula: Expression, part: Expression, value: Expression) -> Iterator[Expression]:
    """Yield what one operand must equal so that formula = value, by the inverse of the outermost operation."""
    match formula:
        case Sum():
            yield reduce(sum_terms, (-term for term in formula.terms if term is not part), value)
        case Product():
            rest = reduce(multiply_factors, (factor for factor in formula.factors if factor is not part))
            yield ratio(value, rest)
        case Quotient() if part is formula.above:
            yield multiply_factors(value, formula.below)
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


SEARCH_POINTS = 801  # samples of the range of an unknown
SEARCH_RATIO = 1e4  # ratio of the largest and smallest value of the range to the known value
BISECTION_STEPS = 60  # steps of bisection
POLE_RATIO = 1e-3  # relative to the values beside a change of sign: larger residuals are those of a pole


def is_explicit(chain: Chain) -> bool:
    """Return whether no formula of a chain is a root of an implicit equation, so that all can be evaluated directly."""
    return not any(isinstance(formula, ImplicitRoot) for _, formula in chain.formulas)


def values_with(chain: Chain, target: float, unknown: str, book: SolutionBuilder) -> list[float]:
    """Return the values of an unknown, in SI units, at which the last formula of a chain equals `target`.

    The search covers values with the sign of the known value; angles up to 90°, coefficients of restitution up to 1.
    """
    try:
        plain = with_known_values(chain, book.values, unknown)
    except (ValueError, ArithmeticError):  # then the chain has no value anywhere
        return []
    left = {name: book.values[name] for name in plain.symbols()}

    def off(value: float) -> float:
        try:
            reached = plain.value({**left, unknown: value})
        except (ValueError, ArithmeticError):
            return float("nan")
        return reached - target if isinstance(reached, float) else float("nan")

    points = _points(unknown, book)
    sides = [off(point) for point in points]
    reached: list[float] = []
    for n in range(len(points) - 1):
        ends = isfinite(sides[n]) and isfinite(sides[n + 1])
        if ends and (sides[n] * sides[n + 1] < 0.0 or sides[n + 1] == 0.0 or (n == 0 and sides[n] == 0.0)):
            low, high = points[n], points[n + 1]
            for _ in range(BISECTION_STEPS):
                middle = 0.5 * (low + high)
                low, high = (middle, high) if off(middle) * off(low) > 0.0 else (low, middle)
            if abs(off(low)) <= POLE_RATIO * max(abs(sides[n]), abs(sides[n + 1])):
                reached.append(0.5 * (low + high))
    return reached


def is_restitution(name: str, book: SolutionBuilder) -> bool:
    """Return whether a symbol is a coefficient of restitution, which is at most 1."""
    return name.partition("_")[0] == "e" and not book.units[name] and 0.0 < book.values[name] <= 1.0


def range_text(unknown: str, book: SolutionBuilder) -> str:
    """Return the range in which an unknown was searched for, in words such as *positive $m$*."""
    name = f"${unknown}$"
    if book.units[unknown] == DEGREES:
        return f"{name} between $0^\\circ$ and $90^\\circ$"
    if is_restitution(unknown, book):
        return f"{name} between 0 and 1"
    return f"{'negative' if book.values[unknown] < 0.0 else 'positive'} {name}"


def _points(unknown: str, book: SolutionBuilder) -> list[float]:
    """Return the sample values of an unknown, in SI units, between which its other solutions are searched for."""
    known = book.values[unknown]
    if book.units[unknown] == DEGREES and 0.0 < known < 0.5 * pi:
        return np.linspace(0.0, 0.5 * pi, SEARCH_POINTS).tolist()
    if is_restitution(unknown, book):
        return np.linspace(0.0, 1.0, SEARCH_POINTS).tolist()
    return (known * np.geomspace(1.0 / SEARCH_RATIO, SEARCH_RATIO, SEARCH_POINTS)).tolist()


MAX_FORMULA_LENGTH = 160  # maximum length of the LaTeX of a formula that is written out
NamedRoot = tuple[Symbol, Expression, float]
"""The symbol of a root, the formula that vanishes there, and a number near it."""
SMALLEST = "The smallest positive solution, found numerically, is"


def root_sentence(
    book: SolutionBuilder, step: StepBuilder, name: Symbol, residual: Expression, near: float, unit: str, text: str
) -> str:
    """Return a sentence that gives a name the value of the root of `residual` near a number, in closed form if short.

    If the equation has a short solution, the sentence gives its formula without the words `text`. Otherwise, if the
    formula depends on the unknown, the sentence is empty: the equation, which was stated, defines the name.
    """
    closed = solved_for(name.name, residual, ZERO, {**book.values, name.name: near})
    if not isinstance(closed, NumericRoot) and len(closed.latex()) <= MAX_FORMULA_LENGTH:
        return f"Hence {step.result(name, closed, unit)}."
    return roots_sentence(book, step, [(name, residual, near)], unit, text)


def roots_sentence(book: SolutionBuilder, step: StepBuilder, roots: Sequence[NamedRoot], unit: str, text: str) -> str:
    """Return a sentence with the numerical roots of several formulas; empty if they depend on the unknown."""
    equations, hidden = list[str](), False
    for name, residual, near in roots:
        hidden = hidden or not book.hidden.isdisjoint(residual.names)
        equations.append(step.result(name, (ImplicitRoot if hidden else NumericRoot)(residual, name.name, near), unit))
    return "" if hidden else f"{text} {join_words(equations)}."
