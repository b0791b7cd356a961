"""LaTeX of simplified formulas: no nested fractions, repeated factors as powers, common factors cancelled."""

import re
from collections.abc import Mapping
from functools import reduce
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
    added,
    multiplied,
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


def without_nested_fractions(held: Expression) -> Expression:
    """Rewrite a formula without nested fractions; its value is unchanged.

    Arguments of functions may contain fractions. A root of a fraction is a separate factor.
    """
    if not held.parts or isinstance(held, NumericFormula):
        return held
    if isinstance(held, Absolute) and isinstance(held.inside, Number):
        return Number(abs(held.inside.x))
    parts = [without_nested_fractions(part) for part in held.parts]
    found = held if all(map(is_, parts, held.parts)) else held.built_of(parts)
    return _one_storey(found)


def _one_storey(held: Expression) -> Expression:
    """Remove nested fractions from a formula whose parts have none."""
    match held:
        case Quotient(above, below) if has_fraction(above) or has_fraction(below) or is_reducible(held):
            return _reduced(held)
        case Product(factors):
            return _reduced(held) if is_reducible(held) else reduce(multiplied, sorted(factors, key=factor_rank))
        case Power(base, exponent) if exponent % 2 == 0 and any(isinstance(f, Root) for f in factors_of(base).powers):
            return _reduced(held)
        case Root(inside):
            return _root(held, inside)
        case Sum():
            return _with_like_terms_added(held)
        case _:
            return held


def has_nested_fraction(held: Expression) -> bool:
    """Return whether a formula contains a nested fraction."""
    if isinstance(held, NumericFormula):
        return False
    here = isinstance(held, Quotient) and (has_fraction(held.above) or has_fraction(held.below))
    return here or any(map(has_nested_fraction, held.parts))


def is_reducible(held: Expression) -> bool:
    """Return whether a product or fraction has a repeated factor, or one that cancels with a factor under a root."""
    if not isinstance(held, Product | Quotient):
        return False
    factors = [factor for side in _sides(held) for factor in _factors(side)]
    bases = [factor.base if isinstance(factor, Power) else factor for factor in factors]
    plain = [base for base in bases if not isinstance(base, Number)]
    if len(set(plain)) < len(plain) or any(_is_size_of_fraction(base) for base in plain):
        return True
    inside = {base for root in plain if isinstance(root, Root) for base in factors_of(root.inside).powers}
    return not inside.isdisjoint(plain)


def _is_size_of_fraction(held: Expression) -> bool:
    """Return whether a formula is the absolute value of a fraction."""
    return isinstance(held, Absolute) and isinstance(held.inside, Quotient)


def _sides(held: Expression) -> tuple[Expression, ...]:
    """Return all numerators and denominators of the fractions in a product."""
    match held:
        case Quotient(above, below):
            return above, below
        case Product(factors):
            return tuple(side for factor in factors for side in _sides(factor))
        case _:
            return (held,)


def _factors(held: Expression) -> tuple[Expression, ...]:
    """Return the factors of a product; other formulas are their own only factor."""
    return held.factors if isinstance(held, Product) else (held,)


# ---- one fraction


def _reduced(held: Expression) -> Expression:
    """Return a product or fraction as a single fraction, with roots of fractions as separate factors."""
    whole = _upright(_with_roots_reduced(_unfolded(factors_of(held, _as_fraction))))
    beside = {base: power for base, power in whole.powers.items() if power > 0 and has_fraction(base)}
    left = Factors(whole.number, {base: power for base, power in whole.powers.items() if base not in beside})
    return multiplied(left.written(), Factors(1.0, beside).product())


def _upright(whole: Factors) -> Factors:
    """Remove a negative number from factors by reversing a difference among them."""
    base = next((base for base, power in whole.powers.items() if power % 2 and is_difference(base)), None)
    if whole.number > 0.0 or base is None:
        return whole
    return Factors(-whole.number, {-base if other is base else other: n for other, n in whole.powers.items()})


def _unfolded(whole: Factors) -> Factors:
    """Expand absolute values of fractions and even powers of roots in factors."""
    found = Factors(whole.number, {})
    for base, power in whole.powers.items():
        match base:
            case Root(inside):
                pairs = int(power / 2)
                single = power - 2 * pairs
                found *= factors_of(inside, _as_fraction if power < 0 else _same).raised(pairs)
                found *= Factors(1.0, {base: single} if single else {})
            case Absolute(Quotient(above, below)):
                sizes = Factors(1.0, {_size(above): 1}) * Factors(1.0, {_size(below): -1})
                found *= sizes.raised(power)
            case _:
                found *= Factors(1.0, {base: power})
    return found


def _same(held: Sum) -> Expression:
    """Return the sum unchanged: the default replacement of sums when a formula is split into factors."""
    return held


def _size(held: Expression) -> Expression:
    """Return the absolute value of a formula, without bars if it is never negative."""
    return held if never_negative(held) else Absolute(held)


# ---- sums


def _as_fraction(held: Sum) -> Expression:
    """Return a sum with fractions among its terms as one fraction; other sums are returned unchanged."""
    terms = [factors_of(term, _as_fraction) for term in held.terms]
    if not any(_is_divided(term) for term in terms):
        return held
    below: dict[Expression, int] = {}
    for term in terms:
        for base, power in term.powers.items():
            below[base] = max(below.get(base, 0), -power)
    number = float(lcm(*(int(integer_sides(term.number)[1]) for term in terms)))
    if number > LARGEST_DENOMINATOR:  # then the numbers are no fractions, but decimals
        return held
    common = Factors(number, {base: power for base, power in below.items() if power})
    above = added(*((term * common).product() for term in _together(terms, common)))
    shared = _shared(above)
    inner = added(*((factors_of(term) * shared.raised(-1)).written() for term in _terms(above)))
    return (Factors(shared.number, shared.powers) * factors_of(inner) * common.raised(-1)).written()


def _together(terms: list[Factors], common: Factors) -> list[Factors]:
    """Combine the terms without denominators into one sum if another term has a sum as its denominator."""
    whole = [term for term in terms if not _is_divided(term)]
    if len(whole) < 2 or not any(isinstance(base, Sum) for base in common.powers):
        return terms
    both = Factors(1.0, {added(*(term.product() for term in whole)): 1})
    return [*(term for term in terms if _is_divided(term)), both]


def _terms(held: Expression) -> tuple[Expression, ...]:
    """Return the terms of a sum; other formulas are their own only term."""
    return held.terms if isinstance(held, Sum) else (held,)


def _is_divided(term: Factors) -> bool:
    """Return whether a term has a denominator."""
    return integer_sides(term.number)[1] != 1.0 or any(power < 0 for power in term.powers.values())


def _shared(held: Expression) -> Factors:
    """Return the common factors of all terms of a sum; no factors for a single term."""
    first, *others = (factors_of(term) for term in _terms(held))
    if not others:
        return Factors(1.0, {})
    shared = dict(first.powers)
    for other in others:
        shared = {base: min(power, other.powers[base]) for base, power in shared.items() if base in other.powers}
    return Factors(1.0, shared)


def _with_like_terms_added(held: Sum) -> Expression:
    """Return a sum with its like terms combined."""
    found: dict[frozenset[tuple[Expression, int]], tuple[float, Mapping[Expression, int]]] = {}
    terms = [factors_of(term) for term in held.terms]
    for term in terms:
        key = frozenset(term.powers.items())
        before, powers = found.get(key, (0.0, term.powers))
        found[key] = before + term.number, powers
    if len(found) == len(terms):
        return held
    return added(*(Factors(number, powers).written() for number, powers in found.values() if number))


# ---- roots


def _root(held: Root, inside: Expression) -> Expression:
    """Simplify the sign of a radicand and take a square number out of the root."""
    if not isinstance(inside, Quotient | Product):
        return held
    whole = factors_of(inside)
    over, under = integer_sides(whole.number)
    number = sqrt(over) if over > 1.0 and under == 1.0 and sqrt(over).is_integer() else 1.0
    if number == 1.0 and over > 0.0:
        return held
    return multiplied(Number(number), Root(_upright(Factors(whole.number / number**2, whole.powers)).written()))


def _with_roots_reduced(whole: Factors) -> Factors:
    """Rewrite factors without roots of fractions in the denominator, and cancel factors with roots of the same base."""
    found = whole
    for root, power in whole.powers.items():
        if isinstance(root, Root):
            found = _with_root_reduced(found, root, power)
    return found


def _with_root_reduced(whole: Factors, root: Root, power: int) -> Factors:
    """Invert a root of a fraction in the denominator and cancel its radicand with other factors."""
    if power < 0 and not (has_fraction(root.inside) or _base_above(whole, root)):
        return whole
    inside = factors_of(root.inside, _as_fraction if power < 0 else _same).raised(1 if power > 0 else -1)
    rest = whole * Factors(1.0, {root: -power})
    for base, outer in rest.powers.items():
        inner = inside.powers.get(base, 0)
        if inner * outer < 0 and _is_positive_in(base, inside):
            step = 1 if outer > 0 else -1
            inside *= Factors(1.0, {base: 2 * step})
            rest *= Factors(1.0, {base: -step})
    if inside.raised(power).powers == factors_of(root.inside).powers and power > 0:
        return whole
    return rest * _root_of(inside)


def _base_above(whole: Factors, root: Root) -> bool:
    """Return whether a factor of a radicand also occurs outside the root, in the numerator."""
    inside = factors_of(root.inside)
    return any(whole.powers.get(base, 0) > 0 for base, power in inside.powers.items() if power > 0)


def _is_positive_in(base: Expression, inside: Factors) -> bool:
    """Return whether a factor of a radicand is positive, by itself or because all others are."""
    others = Factors(inside.number, {other: power for other, power in inside.powers.items() if other != base})
    return never_negative(base) or (inside.powers[base] % 2 == 1 and others.never_negative())


def _root_of(inside: Factors) -> Factors:
    """Return the square root of a product given by its factors, again as factors."""
    formula = inside.written()
    return factors_of(_root(Root(formula), formula)) if formula != ONE else Factors(1.0, {})


SIGN_PATTERN = re.compile(r"\\left\(-|-\\frac|-\\left\(|\{-")
"""Matches the LaTeX of formulas whose signs can be simplified."""
SYMBOL = r"(?<![A-Za-z\\])(\\?[A-Za-z]+(?:_\w|_\{[^{}]*\})?)"
REPEATED_SYMBOL_PATTERN = re.compile(SYMBOL + r"(?:\^\{\d\})? \1(?![\w'])")
"""Matches the LaTeX of products in which a symbol stands twice."""


def plain_latex(held: Expression) -> str:
    """Return the LaTeX of a formula after simplification of its signs and fractions."""
    found = held.latex()
    if SIGN_PATTERN.search(found):
        found = (held := with_plain_signs(held)).latex()
    fractions = found.count("frac{")
    nested = fractions > 1 and has_nested_fraction(held)
    if nested or (fractions and is_reducible(held)) or REPEATED_SYMBOL_PATTERN.search(found):
        return without_nested_fractions(held).latex()
    return found
