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
    multiplied,
    ratio,
    simple_fraction,
)
from sim2reason.solutions.algebra.functions import Absolute, Pi, Power, Root, is_difference, simplify_inverse
from sim2reason.solutions.algebra.plain_latex import without_nested_fractions
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
        found = without_nested_fractions(tidy(_of_size(_rooted_in_sizes(self.expression, points), points)))
        return ClosedForm(found, found.latex(), self.symbols)

    def without_roots_of_squares(self, at: Mapping[str, float] | None = None) -> "ClosedForm":
        """Take squares out of roots, as absolute values or with the sign of their base at the values `at`."""
        found = without_nested_fractions(tidy(_out_of_roots(self.expression, at)))
        return ClosedForm(found, found.latex(), self.symbols)

    def with_positive_factors(self, points: Sequence[Mapping[str, float]]) -> "ClosedForm":
        """Reverse pairs of factors that are negative at all given values of the symbols, so that both are positive."""
        found = _with_positive_factors(self.expression, points)
        return ClosedForm(found, found.latex(), self.symbols)

    def value(self, at: Mapping[str, float]) -> float:
        """Return the value; ValueError or ZeroDivisionError where it is undefined."""
        found = self.expression.value(at)
        assert not isinstance(found, complex)
        return found


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
    found = Substitution(definitions(solution), {name: renamed.get(name, name) for name in given}).named(solution.goal)
    if (bare := _without_bars(found)) != found:
        at = {renamed.get(name, name): solution.values[name] for name in given}
        signed = any(at.get(name, 0.0) < 0.0 for name in bare.symbols())
        found = -bare if _negative(bare, at) else bare
        found = Absolute(found) if signed else found  # the sign of the formula is not evident
    if hopeless(found):
        raise ClosedFormError("it has too many roots")
    return found


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


def _without_bars(held: Expression) -> Expression:
    """Remove absolute values from a formula or its factors; the caller restores the sign."""
    match held:
        case Absolute():
            return held.inside
        case Product():
            return reduce(multiplied, map(_without_bars, held.factors))
        case Quotient():
            return ratio(_without_bars(held.above), _without_bars(held.below))
        case _:
            return held


def hopeless(whole: Expression) -> bool:
    """Return whether a formula with so many roots is too long to be simplified, since roots do not cancel."""
    roots = len(set(_roots(whole)))
    most = next(
        (characters for count, characters in sorted(MAX_LATEX_BY_ROOTS.items(), reverse=True) if roots >= count), inf
    )
    return len(whole.latex()) > most


def _roots(held: Expression) -> Iterator[str]:
    """Yield the LaTeX of all roots in a formula."""
    if isinstance(held, Root):
        yield held.latex()
    for part in held.parts:
        yield from _roots(part)


def simplified_form(whole: Expression) -> ClosedForm:
    """Simplify a formula; ClosedFormError if the result is too long."""
    found = _written(whole)
    if len(found.latex) > MAX_LATEX_LENGTH:
        raise ClosedFormError(f"it takes {len(found.latex)} characters")
    return found


@lru_cache(maxsize=512)
def _written(whole: Expression) -> ClosedForm:
    """Simplify a formula as far as possible; cached, since scenes with other numbers have the same formula."""
    if isinstance(whole, Absolute):
        found = Absolute(_written(whole.inside).expression)
        return ClosedForm(found, found.latex(), tuple(sorted(set(found.symbols()))))
    found = min((_reduced(held) for held in (shortest_form(whole, MAX_LATEX_LENGTH), whole)), key=latex_length)
    return ClosedForm(found, found.latex(), tuple(sorted(set(found.symbols()))))


def _reduced(whole: Expression) -> Expression:
    """Return a formula with common factors in front and without nested fractions."""
    return without_nested_fractions(tidy(with_factors_in_front(tidy(factor_terms(tidy(whole))))))


def _rooted_in_sizes(held: Expression, points: Sequence[Mapping[str, float]]) -> Expression:
    """Replace radicands that are negative at any of the given values of the symbols by their absolute values."""
    if not held.parts:
        return held
    parts = [_rooted_in_sizes(part, points) for part in held.parts]
    return held.built_of([_of_size(part, points) for part in parts] if isinstance(held, Root) else parts)


def _of_size(held: Expression, points: Sequence[Mapping[str, float]]) -> Expression:
    """Return the absolute value of a formula that is negative at any given values of its symbols; else the formula."""
    return _positive(held, points) if any(_negative(held, at) for at in points) else held


def _positive(held: Expression, points: Sequence[Mapping[str, float]]) -> Expression:
    """Return the absolute value of a formula: bars around factors of either sign, negative factors negated."""
    if isinstance(held, Quotient):
        return ratio(_positive(held.above, points), _positive(held.below, points))
    factors = held.factors if isinstance(held, Product) else (held,)
    outer, inner = ONE, ONE
    for factor in factors:
        negative = [_negative(factor, at) for at in points]
        if any(negative) and not all(negative):
            inner = multiplied(inner, factor)
        else:
            outer = multiplied(outer, -factor if any(negative) else factor)
    return outer if inner == ONE else multiplied(outer, Absolute(inner))


def _with_positive_factors(held: Expression, points: Sequence[Mapping[str, float]]) -> Expression:
    """Reverse pairs of factors that are negative at all given values of the symbols."""
    if isinstance(held, Product) and any(isinstance(factor, Quotient) for factor in held.factors):
        return reduce(multiplied, (_with_positive_factors(factor, points) for factor in held.factors))
    above, below = (held.above, held.below) if isinstance(held, Quotient) else (held, ONE)
    sides = [list(side.factors) if isinstance(side, Product) else [side] for side in (above, below)]
    negative = [(side, n) for side in sides for n, factor in enumerate(side) if _is_reversible(factor, points)]
    if not negative or (len(negative) % 2 == 1) != held.negative:
        return held
    for side, n in negative:
        side[n] = -side[n]
    sign = Number(-1.0) if len(negative) % 2 else ONE
    return ratio(reduce(multiplied, sides[0], sign), reduce(multiplied, sides[1], ONE))


def _is_reversible(factor: Expression, points: Sequence[Mapping[str, float]]) -> bool:
    """Return whether a factor is a difference that is negative at all given values of the symbols."""
    return is_difference(factor) and all(_negative(factor, at) for at in points)


def _negative(held: Expression, at: Mapping[str, float]) -> bool:
    """Return whether a formula has a negative value."""
    try:
        return held.value(at).real < 0.0
    except (ValueError, ArithmeticError):
        return False


def _out_of_roots(held: Expression, at: Mapping[str, float] | None) -> Expression:
    """Take the squares in radicands out of roots."""
    if not held.parts:
        return held
    found = held.built_of([_out_of_roots(part, at) for part in held.parts])
    if not isinstance(found, Root):
        return found
    inside = found.inside
    above, below = (inside.above, inside.below) if isinstance(inside, Quotient) else (inside, ONE)
    (outer, inner), (under, left) = _squares_apart(above), _squares_apart(below)
    if outer == under == ONE:
        return found
    size = ratio(outer, under)
    if at is None:
        size = Absolute(size)
    elif _negative(size, at):
        size = -size
    if inner == ONE:
        return size if left == ONE else ratio(size, Root(left))
    return multiplied(size, Root(ratio(inner, left)))


def _squares_apart(product: Expression) -> tuple[Expression, Expression]:
    """Split a product into the square root of its even powers, and its other factors."""
    squared, left = ONE, ONE
    for factor in product.factors if isinstance(product, Product) else (product,):
        if isinstance(factor, Power) and factor.exponent % 2 == 0:
            half = factor.exponent // 2
            squared = multiplied(squared, factor.base if half == 1 else Power(factor.base, half))
        else:
            left = multiplied(left, factor)
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
            self._known[name] = found = self.of(self._definitions[name])
            if sum(1 for _ in found.symbols()) > MAX_SYMBOLS:
                raise ClosedFormError("its formula grows too long")
        return self._known[name]

    def of(self, held: Expression) -> Expression:
        """Return a formula with all names substituted."""
        match held:
            case Symbol():
                found = self.named(held.name)
            case Number():
                found = _simple(held)
            case Pi():
                found = held
            case NumericFormula():
                found = self.of(held.inner)
            case SpecialFunction():
                raise ClosedFormError("it needs a special function")
            case _ if held.parts:
                found = simplify_inverse(held.built_of([self.of(part) for part in held.parts]))
            case _:
                raise ClosedFormError("a number in it was found numerically")
        return found


def _simple(number: Number) -> Number:
    """Return a number if it may stand in a closed form; ClosedFormError if it hides given quantities."""
    if simple_fraction(number.x) is None:
        raise ClosedFormError(f"the number {number.x:g} in it is no simple one")
    return number
