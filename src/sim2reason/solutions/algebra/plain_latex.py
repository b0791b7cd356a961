"""LaTeX of simplified formulas: no nested fractions, repeated factors as powers, common factors cancelled."""

import re
from collections.abc import Mapping
from functools import lru_cache, reduce
from math import lcm, sqrt
from operator import is_

from sim2reason.solutions.algebra.evaluated import NumericFormula
from sim2reason.solutions.algebra.expressions import (
    ONE,
    Expression,
    Number,
    Product,
    Quotient,
    Sum,
    multiply_factors,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import Absolute, Power, Root, is_difference, with_plain_signs
from sim2reason.solutions.algebra.transformations import (
    LARGEST_DENOMINATOR,
    Factors,
    factor_rank,
    factors_of,
    has_fraction,
    integer_sides,
    never_negative,
)


def without_nested_fractions(expression: Expression) -> Expression:
    """Rewrite a formula without nested fractions; its value is unchanged.

    Arguments of functions may contain fractions. A root of a fraction is a separate factor.
    """
    if not expression.parts or isinstance(expression, NumericFormula):
        return expression
    if isinstance(expression, Absolute) and isinstance(expression.inside, Number):
        return Number(abs(expression.inside.x))
    parts = [without_nested_fractions(part) for part in expression.parts]
    rebuilt = expression if all(map(is_, parts, expression.parts)) else expression.built_of(parts)
    return _one_storey(rebuilt)


def _one_storey(expression: Expression) -> Expression:
    """Remove nested fractions from a formula whose parts have none."""
    match expression:
        case Quotient(above, below) if has_fraction(above) or has_fraction(below) or is_reducible(expression):
            return _reduced(expression)
        case Product(factors):
            return (
                _reduced(expression)
                if is_reducible(expression)
                else reduce(multiply_factors, sorted(factors, key=factor_rank))
            )
        case Power(base, exponent) if exponent % 2 == 0 and any(isinstance(f, Root) for f in factors_of(base).powers):
            return _reduced(expression)
        case Root(inside):
            return _root(expression, inside)
        case Sum():
            return _with_like_terms_added(expression)
        case _:
            return expression


def has_nested_fraction(expression: Expression) -> bool:
    """Return whether a formula contains a nested fraction."""
    if isinstance(expression, NumericFormula):
        return False
    here = isinstance(expression, Quotient) and (has_fraction(expression.above) or has_fraction(expression.below))
    return here or any(map(has_nested_fraction, expression.parts))


def is_reducible(expression: Expression) -> bool:
    """Return whether a product or fraction has a repeated factor, or one that cancels with a factor under a root."""
    if not isinstance(expression, Product | Quotient):
        return False
    factors = [factor for side in _sides(expression) for factor in _factors(side)]
    bases = [factor.base if isinstance(factor, Power) else factor for factor in factors]
    plain = [base for base in bases if not isinstance(base, Number)]
    if len(set(plain)) < len(plain) or any(_is_size_of_fraction(base) for base in plain):
        return True
    inside = {base for root in plain if isinstance(root, Root) for base in factors_of(root.inside).powers}
    return not inside.isdisjoint(plain)


def _is_size_of_fraction(expression: Expression) -> bool:
    """Return whether a formula is the absolute value of a fraction."""
    return isinstance(expression, Absolute) and isinstance(expression.inside, Quotient)


def _sides(expression: Expression) -> tuple[Expression, ...]:
    """Return all numerators and denominators of the fractions in a product."""
    match expression:
        case Quotient(above, below):
            return above, below
        case Product(factors):
            return tuple(side for factor in factors for side in _sides(factor))
        case _:
            return (expression,)


def _factors(expression: Expression) -> tuple[Expression, ...]:
    """Return the factors of a product; other formulas are their own only factor."""
    return expression.factors if isinstance(expression, Product) else (expression,)


# ---- one fraction


def _reduced(expression: Expression) -> Expression:
    """Return a product or fraction as a single fraction, with roots of fractions as separate factors."""
    factors = _upright(_with_roots_reduced(_unfolded(factors_of(expression, _as_fraction))))
    beside = {base: power for base, power in factors.powers.items() if power > 0 and has_fraction(base)}
    left = Factors(factors.number, {base: power for base, power in factors.powers.items() if base not in beside})
    return multiply_factors(left.as_formula(), Factors(1.0, beside).product())


def _upright(factors: Factors) -> Factors:
    """Remove a negative number from factors by reversing a difference among them."""
    base = next((base for base, power in factors.powers.items() if power % 2 and is_difference(base)), None)
    if factors.number > 0.0 or base is None:
        return factors
    return Factors(-factors.number, {-base if other is base else other: n for other, n in factors.powers.items()})


def _unfolded(factors: Factors) -> Factors:
    """Expand absolute values of fractions and even powers of roots in factors."""
    expanded = Factors(factors.number, {})
    for base, power in factors.powers.items():
        match base:
            case Root(inside):
                pairs = int(power / 2)
                single = power - 2 * pairs
                expanded *= factors_of(inside, _as_fraction if power < 0 else _same).power(pairs)
                expanded *= Factors(1.0, {base: single} if single else {})
            case Absolute(Quotient(above, below)):
                sizes = Factors(1.0, {_size(above): 1}) * Factors(1.0, {_size(below): -1})
                expanded *= sizes.power(power)
            case _:
                expanded *= Factors(1.0, {base: power})
    return expanded


def _same(expression: Sum) -> Expression:
    """Return the sum unchanged: the default replacement of sums when a formula is split into factors."""
    return expression


def _size(expression: Expression) -> Expression:
    """Return the absolute value of a formula, without bars if it is never negative."""
    return expression if never_negative(expression) else Absolute(expression)


# ---- sums


def _as_fraction(expression: Sum) -> Expression:
    """Return a sum with fractions among its terms as one fraction; other sums are returned unchanged."""
    terms = [factors_of(term, _as_fraction) for term in expression.terms]
    if not any(_is_divided(term) for term in terms):
        return expression
    below: dict[Expression, int] = {}
    for term in terms:
        for base, power in term.powers.items():
            below[base] = max(below.get(base, 0), -power)
    number = float(lcm(*(int(integer_sides(term.number)[1]) for term in terms)))
    if number > LARGEST_DENOMINATOR:  # then the numbers are no fractions, but decimals
        return expression
    common = Factors(number, {base: power for base, power in below.items() if power})
    above = sum_terms(*((term * common).product() for term in _together(terms, common)))
    shared = _shared(above)
    inner = sum_terms(*((factors_of(term) * shared.power(-1)).as_formula() for term in _terms(above)))
    return (Factors(shared.number, shared.powers) * factors_of(inner) * common.power(-1)).as_formula()


def _together(terms: list[Factors], common: Factors) -> list[Factors]:
    """Combine the terms without denominators into one sum if another term has a sum as its denominator."""
    undivided = [term for term in terms if not _is_divided(term)]
    if len(undivided) < 2 or not any(isinstance(base, Sum) for base in common.powers):
        return terms
    both = Factors(1.0, {sum_terms(*(term.product() for term in undivided)): 1})
    return [*(term for term in terms if _is_divided(term)), both]


def _terms(expression: Expression) -> tuple[Expression, ...]:
    """Return the terms of a sum; other formulas are their own only term."""
    return expression.terms if isinstance(expression, Sum) else (expression,)


def _is_divided(term: Factors) -> bool:
    """Return whether a term has a denominator."""
    return integer_sides(term.number)[1] != 1.0 or any(power < 0 for power in term.powers.values())


def _shared(expression: Expression) -> Factors:
    """Return the common factors of all terms of a sum; no factors for a single term."""
    first, *others = (factors_of(term) for term in _terms(expression))
    if not others:
        return Factors(1.0, {})
    shared = dict(first.powers)
    for other in others:
        shared = {base: min(power, other.powers[base]) for base, power in shared.items() if base in other.powers}
    return Factors(1.0, shared)


def _with_like_terms_added(expression: Sum) -> Expression:
    """Return a sum with its like terms combined."""
    combined: dict[frozenset[tuple[Expression, int]], tuple[float, Mapping[Expression, int]]] = {}
    terms = [factors_of(term) for term in expression.terms]
    for term in terms:
        key = frozenset(term.powers.items())
        before, powers = combined.get(key, (0.0, term.powers))
        combined[key] = before + term.number, powers
    if len(combined) == len(terms):
        return expression
    return sum_terms(*(Factors(number, powers).as_formula() for number, powers in combined.values() if number))


# ---- roots


def _root(root: Root, inside: Expression) -> Expression:
    """Simplify the sign of a radicand and take a square number out of the root."""
    if not isinstance(inside, Quotient | Product):
        return root
    factors = factors_of(inside)
    over, under = integer_sides(factors.number)
    number = sqrt(over) if over > 1.0 and under == 1.0 and sqrt(over).is_integer() else 1.0
    if number == 1.0 and over > 0.0:
        return root
    return multiply_factors(
        Number(number), Root(_upright(Factors(factors.number / number**2, factors.powers)).as_formula())
    )


def _with_roots_reduced(factors: Factors) -> Factors:
    """Rewrite factors without roots of fractions in the denominator, and cancel factors with roots of the same base."""
    reduced = factors
    for root, power in factors.powers.items():
        if isinstance(root, Root):
            reduced = _with_root_reduced(reduced, root, power)
    return reduced


def _with_root_reduced(factors: Factors, root: Root, power: int) -> Factors:
    """Invert a root of a fraction in the denominator and cancel its radicand with other factors."""
    if power < 0 and not (has_fraction(root.inside) or _base_above(factors, root)):
        return factors
    inside = factors_of(root.inside, _as_fraction if power < 0 else _same).power(1 if power > 0 else -1)
    rest = factors * Factors(1.0, {root: -power})
    for base, outer in rest.powers.items():
        inner = inside.powers.get(base, 0)
        if inner * outer < 0 and _is_positive_in(base, inside):
            step = 1 if outer > 0 else -1
            inside *= Factors(1.0, {base: 2 * step})
            rest *= Factors(1.0, {base: -step})
    if inside.power(power).powers == factors_of(root.inside).powers and power > 0:
        return factors
    return rest * _root_of(inside)


def _base_above(factors: Factors, root: Root) -> bool:
    """Return whether a factor of a radicand also occurs outside the root, in the numerator."""
    inside = factors_of(root.inside)
    return any(factors.powers.get(base, 0) > 0 for base, power in inside.powers.items() if power > 0)


def _is_positive_in(base: Expression, inside: Factors) -> bool:
    """Return whether a factor of a radicand is positive, by itself or because all others are."""
    others = Factors(inside.number, {other: power for other, power in inside.powers.items() if other != base})
    return never_negative(base) or (inside.powers[base] % 2 == 1 and others.never_negative())


def _root_of(inside: Factors) -> Factors:
    """Return the square root of a product given by its factors, again as factors."""
    formula = inside.as_formula()
    return factors_of(_root(Root(formula), formula)) if formula != ONE else Factors(1.0, {})


SIGN_PATTERN = re.compile(r"\\left\(-|-\\frac|-\\left\(|\{-")
"""Matches the LaTeX of formulas whose signs can be simplified."""
SYMBOL = r"(?<![A-Za-z\\])(\\?[A-Za-z]+(?:_\w|_\{[^{}]*\})?)"
REPEATED_SYMBOL_PATTERN = re.compile(SYMBOL + r"(?:\^\{\d\})? \1(?![\w'])")
"""Matches the LaTeX of products in which a symbol stands twice."""


@lru_cache(maxsize=4096)
def plain_latex(expression: Expression) -> str:
    """Return the LaTeX of a formula after simplification of its signs and fractions, cached for repeated formulas."""
    latex = expression.latex()
    if SIGN_PATTERN.search(latex):
        latex = (expression := with_plain_signs(expression)).latex()
    fractions = latex.count("frac{")
    nested = fractions > 1 and has_nested_fraction(expression)
    if nested or (fractions and is_reducible(expression)) or REPEATED_SYMBOL_PATTERN.search(latex):
        return without_nested_fractions(expression).latex()
    return latex
