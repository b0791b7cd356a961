"""Closed forms: the answer of a worked solution as one formula of the given quantities."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache, reduce
from math import inf

from sim2reason.solutions.algebra.evaluated import NumericFormula, SpecialFunction
from sim2reason.solutions.algebra.expressions import (
    ONE,
    Expression,
    Number,
    Product,
    Quotient,
    Symbol,
    multiply_factors,
    ratio,
)
from sim2reason.solutions.algebra.functions import Absolute, Pi, Power, Root, is_difference, simplify_inverse
from sim2reason.solutions.algebra.plain_latex import without_nested_fractions
from sim2reason.solutions.algebra.rounded_numbers import simple_fraction
from sim2reason.solutions.closed_forms.gathering import factor_terms, with_factors_in_front
from sim2reason.solutions.closed_forms.rewriting import latex_length, shortest_form
from sim2reason.solutions.closed_forms.tidying import tidy
from sim2reason.solutions.solution import Solution, Step

__all__ = ["MAX_LATEX_LENGTH", "ClosedForm", "ClosedFormError", "closed_form", "combined_formula", "simplified_form"]


MAX_SYMBOLS = 150  # symbols in a formula before simplification, at most
MAX_LATEX_LENGTH = 230  # characters of LaTeX, at most; a sum is repeated in reduced fractions
MAX_LATEX_BY_ROOTS = {
    2: 400,
    3: 250,
}  # by number of different roots: characters of the longest formula worth simplifying


class ClosedFormError(Exception):
    """An error raised for a solution without a closed-form answer; the message has the reason."""


@dataclass(frozen=True)
class ClosedForm:
    """The answer as a formula of the given quantities, in SI units and radians; `symbols` are its sorted names."""

    expression: Expression
    latex: str
    symbols: tuple[str, ...]

    def of_sizes(self, points: Sequence[Mapping[str, float]]) -> "ClosedForm":
        """Return the absolute value of the closed form; radicands negative at one of the `points` get bars, too.

        Factors with one sign at all points get that sign; all others stand between bars.
        """
        expression = without_nested_fractions(tidy(_of_size(_rooted_in_sizes(self.expression, points), points)))
        return ClosedForm(expression, expression.latex(), self.symbols)

    def without_roots_of_squares(self, at: Mapping[str, float] | None = None) -> "ClosedForm":
        """Take squares out of roots, as absolute values or with the sign of their base at the values `at`."""
        expression = without_nested_fractions(tidy(_out_of_roots(self.expression, at)))
        return ClosedForm(expression, expression.latex(), self.symbols)

    def with_positive_factors(self, points: Sequence[Mapping[str, float]]) -> "ClosedForm":
        """Reverse pairs of factors that are negative at all given values of the symbols, so that both are positive."""
        expression = _with_positive_factors(self.expression, points)
        return ClosedForm(expression, expression.latex(), self.symbols)

    def value(self, at: Mapping[str, float]) -> float:
        """Return the value; ValueError or ZeroDivisionError where it is undefined."""
        result = self.expression.value(at)
        assert not isinstance(result, complex)
        return result


def closed_form(solution: Solution, own: Sequence[str] = ()) -> ClosedForm:
    """Return the answer of a solution as one simplified formula."""
    return simplified_form(combined_formula(solution, own))


def combined_formula(solution: Solution, own: Sequence[str] = ()) -> Expression:
    """Return the answer as a formula of given quantities; ClosedFormError if it needs other numbers or is too long.

    `own` has new names for the numbers in the question, in its order, in place of the solution's names.
    """
    if solution.answer is None:
        raise ClosedFormError(solution.reason)
    renamed = dict(zip(solution.stated, own, strict=False))
    every = (relation for step in solution.steps for relation in step.relations if relation.role == "given")
    given = {relation.left.latex() for relation in every} - solution.constants.keys()
    formula = Substitution(definitions(solution), {name: renamed.get(name, name) for name in given}).named(
        solution.goal
    )
    if (bare := _without_bars(formula)) != formula:
        at = {renamed.get(name, name): solution.values[name] for name in given}
        signed = any(at.get(name, 0.0) < 0.0 for name in bare.symbols())
        formula = -bare if _negative(bare, at) else bare
        formula = Absolute(formula) if signed else formula  # the sign of the formula is not evident
    if is_too_complex(formula):
        raise ClosedFormError("it has too many roots")
    return formula


def definitions(solution: Solution) -> dict[str, Expression]:
    """Return the formula by which a solution defines each of its names."""
    return dict(solution.constants) | defined_by(solution.steps)


def defined_by(steps: Sequence[Step]) -> dict[str, Expression]:
    """Return the formula by which steps define each of their names."""
    return {
        relation.left.latex(): relation.right
        for step in steps
        for relation in step.relations
        if relation.left.latex() in step.gives and relation.role in ("result", "law")
    }


def _without_bars(expression: Expression) -> Expression:
    """Remove absolute values from a formula or its factors; the caller restores the sign."""
    match expression:
        case Absolute():
            return expression.inside
        case Product():
            return reduce(multiply_factors, map(_without_bars, expression.factors))
        case Quotient():
            return ratio(_without_bars(expression.above), _without_bars(expression.below))
        case _:
            return expression


def is_too_complex(expression: Expression) -> bool:
    """Return whether a formula with so many roots is too long to be simplified, since roots do not cancel."""
    roots = len(set(_roots(expression)))
    most = next(
        (characters for count, characters in sorted(MAX_LATEX_BY_ROOTS.items(), reverse=True) if roots >= count), inf
    )
    return len(expression.latex()) > most


def _roots(held: Expression) -> Iterator[str]:
    """Yield the LaTeX of all roots in a formula."""
    if isinstance(held, Root):
        yield held.latex()
    for part in held.parts:
        yield from _roots(part)


def simplified_form(expression: Expression) -> ClosedForm:
    """Simplify a formula; ClosedFormError if the result is too long."""
    simplified = _written(expression)
    if len(simplified.latex) > MAX_LATEX_LENGTH:
        raise ClosedFormError(f"it takes {len(simplified.latex)} characters")
    return simplified


@lru_cache(maxsize=512)
def _written(whole: Expression) -> ClosedForm:
    """Simplify a formula as far as possible; cached, since scenes with other numbers have the same formula."""
    if isinstance(whole, Absolute):
        found = Absolute(_written(whole.inside).expression)
        return ClosedForm(found, found.latex(), tuple(sorted(set(found.symbols()))))
    forms = dict.fromkeys((shortest_form(whole, MAX_LATEX_LENGTH), whole))  # often one
    found = min(map(_reduced, forms), key=latex_length)
    return ClosedForm(found, found.latex(), tuple(sorted(set(found.symbols()))))


def _reduced(whole: Expression) -> Expression:
    """Return a formula with common factors in front and without nested fractions."""
    return without_nested_fractions(tidy(with_factors_in_front(tidy(factor_terms(tidy(whole))))))


def _rooted_in_sizes(expression: Expression, points: Sequence[Mapping[str, float]]) -> Expression:
    """Replace radicands that are negative at any of the given values of the symbols by their absolute values."""
    if not expression.parts:
        return expression
    parts = [_rooted_in_sizes(part, points) for part in expression.parts]
    return expression.built_of([_of_size(part, points) for part in parts] if isinstance(expression, Root) else parts)


def _of_size(expression: Expression, points: Sequence[Mapping[str, float]]) -> Expression:
    """Return the absolute value of a formula that is negative at any given values of its symbols; else the formula."""
    return _positive(expression, points) if any(_negative(expression, at) for at in points) else expression


def _positive(held: Expression, points: Sequence[Mapping[str, float]]) -> Expression:
    """Return the absolute value of a formula: bars around factors of either sign, negative factors negated."""
    if isinstance(held, Quotient):
        return ratio(_positive(held.above, points), _positive(held.below, points))
    factors = held.factors if isinstance(held, Product) else (held,)
    outer, inner = ONE, ONE
    for factor in factors:
        negative = [_negative(factor, at) for at in points]
        if any(negative) and not all(negative):
            inner = multiply_factors(inner, factor)
        else:
            outer = multiply_factors(outer, -factor if any(negative) else factor)
    return outer if inner == ONE else multiply_factors(outer, Absolute(inner))


def _with_positive_factors(expression: Expression, points: Sequence[Mapping[str, float]]) -> Expression:
    """Reverse pairs of factors that are negative at all given values of the symbols."""
    if isinstance(expression, Product) and any(isinstance(factor, Quotient) for factor in expression.factors):
        return reduce(multiply_factors, (_with_positive_factors(factor, points) for factor in expression.factors))
    above, below = (expression.above, expression.below) if isinstance(expression, Quotient) else (expression, ONE)
    sides = [list(side.factors) if isinstance(side, Product) else [side] for side in (above, below)]
    negative = [(side, n) for side in sides for n, factor in enumerate(side) if _is_reversible(factor, points)]
    if not negative or (len(negative) % 2 == 1) != expression.negative:
        return expression
    for side, n in negative:
        side[n] = -side[n]
    sign = Number(-1.0) if len(negative) % 2 else ONE
    return ratio(reduce(multiply_factors, sides[0], sign), reduce(multiply_factors, sides[1], ONE))


def _is_reversible(factor: Expression, points: Sequence[Mapping[str, float]]) -> bool:
    """Return whether a factor is a difference that is negative at all given values of the symbols."""
    return is_difference(factor) and all(_negative(factor, at) for at in points)


def _negative(expression: Expression, at: Mapping[str, float]) -> bool:
    """Return whether a formula has a negative value."""
    try:
        return expression.value(at).real < 0.0
    except (ValueError, ArithmeticError):
        return False


def _out_of_roots(expression: Expression, at: Mapping[str, float] | None) -> Expression:
    """Take the squares in radicands out of roots."""
    if not expression.parts:
        return expression
    rebuilt = expression.built_of([_out_of_roots(part, at) for part in expression.parts])
    if not isinstance(rebuilt, Root):
        return rebuilt
    inside = rebuilt.inside
    above, below = (inside.above, inside.below) if isinstance(inside, Quotient) else (inside, ONE)
    (outer, inner), (under, left) = _squares_apart(above), _squares_apart(below)
    if outer == under == ONE:
        return rebuilt
    size = ratio(outer, under)
    if at is None:
        size = Absolute(size)
    elif _negative(size, at):
        size = -size
    if inner == ONE:
        return size if left == ONE else ratio(size, Root(left))
    return multiply_factors(size, Root(ratio(inner, left)))


def _squares_apart(product: Expression) -> tuple[Expression, Expression]:
    """Split a product into the square root of its even powers, and its other factors."""
    squared, left = ONE, ONE
    for factor in product.factors if isinstance(product, Product) else (product,):
        if isinstance(factor, Power) and factor.exponent % 2 == 0:
            half = factor.exponent // 2
            squared = multiply_factors(squared, factor.base if half == 1 else Power(factor.base, half))
        else:
            left = multiply_factors(left, factor)
    return squared, left


class Substitution:
    """The repeated replacement of names by their formulas until only given quantities remain."""

    def __init__(self, definitions: Mapping[str, Expression], given: Mapping[str, str]) -> None:
        """Take the formulas by name and, as `given`, the symbols of the names that remain."""
        self._definitions, self._given = definitions, given
        self._known: dict[str, Expression] = {}

    def named(self, name: str) -> Expression:
        """Return the formula of a named quantity in terms of given quantities."""
        if name in self._given:
            return Symbol(self._given[name])
        if name not in self._known:
            if name not in self._definitions:
                raise ClosedFormError(f"{name} comes from no formula")
            self._known[name] = expression = self.substitute(self._definitions[name])
            if sum(1 for _ in expression.symbols()) > MAX_SYMBOLS:
                raise ClosedFormError("its formula grows too long")
        return self._known[name]

    def substitute(self, held: Expression) -> Expression:
        """Return a formula with all names substituted."""
        match held:
            case Symbol():
                substituted = self.named(held.name)
            case Number():
                substituted = _simple(held)
            case Pi():
                substituted = held
            case NumericFormula():
                substituted = self.substitute(held.inner)
            case SpecialFunction():
                raise ClosedFormError("it needs a special function")
            case _ if held.parts:
                substituted = simplify_inverse(held.built_of([self.substitute(part) for part in held.parts]))
            case _:
                raise ClosedFormError("a number in it was found numerically")
        return substituted


def _simple(number: Number) -> Number:
    """Return a number if it may stand in a closed form; ClosedFormError if it hides given quantities."""
    if simple_fraction(number.x) is None:
        raise ClosedFormError(f"the number {number.x:g} in it is no simple one")
    return number
