"""Sums with common factors in front at any depth, as in g (m_A - m_B)."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import reduce
from itertools import combinations
from math import copysign, gcd, isclose, sqrt

from sim2reason.base.records import record
from sim2reason.solutions.algebra.expressions import (
    ONE,
    ZERO,
    Expression,
    Number,
    Product,
    Quotient,
    Sum,
    multiply_factors,
    ratio,
    sum_terms,
)
from sim2reason.solutions.algebra.functions import Power, is_difference
from sim2reason.solutions.algebra.rounded_numbers import simple_fraction
from sim2reason.solutions.closed_forms.rewriting import latex_length

MAX_TERMS = 30  # terms of a sum that is factored, at most
MAX_CROSS_TERMS = 6  # terms of a sum that is searched for products of two sums, at most


@record()
class Term:
    """A number times factors over other factors; powers are repeated factors."""

    number: float
    factors: tuple[Expression, ...]
    below: tuple[Expression, ...] = ()

    @property
    def as_formula(self) -> Expression:
        """Return the term as a formula."""
        above = reduce(multiply_factors, _raised(self.factors), Number(self.number))
        return ratio(above, reduce(multiply_factors, _raised(self.below), ONE)) if self.below else above

    def without(self, other: "Term") -> "Term":
        """Divide the term by one of its divisors."""
        return Term(self.number / other.number, _less(self.factors, other.factors), _less(self.below, other.below))


def factor_terms(expression: Expression, size: Callable[[Expression], int] = latex_length) -> Expression:
    """Factor common terms out of each sum where that is shorter; the value is unchanged.

    `size` returns the length of a formula, by default that of its LaTeX.
    """
    if not expression.parts:
        return expression
    rebuilt = expression.built_of([factor_terms(part, size) for part in expression.parts])
    if not isinstance(rebuilt, Sum) or len(rebuilt.terms) > MAX_TERMS:
        return rebuilt
    terms = [_term(term) for term in rebuilt.terms]
    crossed = _crosswise(_merged(terms)) if size is latex_length else None
    alike = all(term.number > 0.0 for term in terms)  # with differences, only where that is shorter
    if crossed is not None and (alike or size(crossed) <= size(rebuilt)):
        return crossed
    return min((rebuilt, _plain(_merged(terms)), _product(terms)), key=size)


def with_factors_in_front(expression: Expression) -> Expression:
    """Factor the common factors of all terms out of each sum, at any length; the value is unchanged.

    Factors common to numerator and denominator of a fraction then cancel.
    """
    if not expression.parts:
        return expression
    rebuilt = expression.built_of([with_factors_in_front(part) for part in expression.parts])
    match rebuilt:
        case Sum():
            return _in_front([_term(term) for term in rebuilt.terms]) or rebuilt
        case Quotient():
            fraction = _term(rebuilt)
            plain = _cancelled(fraction)
            return rebuilt if plain == fraction else plain.as_formula
        case _:
            return rebuilt


def _in_front(terms: Sequence[Term]) -> Expression | None:
    """Return the common factors of all terms times the remaining sum; None if there are none."""
    shared = _shared(terms)
    numbers = [abs(term.number) for term in terms]
    if all(number.is_integer() for number in numbers):
        shared = replace(shared, number=copysign(gcd(*map(int, numbers)), shared.number))
    if shared.as_formula in (ONE, Number(-1.0)):
        return None
    rest = _plain([term.without(shared) for term in terms])
    return Term(shared.number, (*shared.factors, rest), shared.below).as_formula


def symbols_in(expression: Expression) -> int:
    """Return the number of symbols in a formula, with repetitions."""
    return sum(1 for _ in expression.symbols())


def parted(expression: Expression) -> Expression:
    """Split fractions of sums and cancel each term by itself, where fewer symbols remain; the value is unchanged.

    For example, (F + (m_A + m_B) g sin θ)/(m_A + m_B) becomes F/(m_A + m_B) + g sin θ.
    """
    if not expression.parts:
        return expression
    rebuilt = expression.built_of([parted(part) for part in expression.parts])
    if not isinstance(rebuilt, Quotient):
        return rebuilt
    fraction = _cancelled(_term(rebuilt))
    return min((rebuilt, fraction.as_formula, *_divide_out_sum(fraction)), key=symbols_in)


def _divide_out_sum(fraction: Term) -> Iterator[Expression]:
    """Yield forms of a fraction in which one sum of the numerator is divided by the denominator term by term."""
    for factor in fraction.factors if fraction.below else ():
        if isinstance(factor, Sum):
            rest = _less(fraction.factors, (factor,))
            terms = [replace(term, below=(*term.below, *fraction.below)) for term in map(_term, factor.terms)]
            yield Term(fraction.number, (*rest, _plain([_cancelled(term) for term in terms]))).as_formula


def _cancelled(term: Term) -> Term:
    """Cancel the common factors of numerator and denominator."""
    return replace(term, factors=_less(term.factors, term.below), below=_less(term.below, term.factors))


def _term(expression: Expression) -> Term:
    """Convert a formula to a term."""
    match expression:
        case Number(x):
            return Term(x, ())
        case Product(factors):
            parts = [_term(factor) for factor in factors]
            number = reduce(lambda one, part: one * part.number, parts, 1.0)
            return Term(number, sum((p.factors for p in parts), ()), sum((p.below for p in parts), ()))
        case Quotient(above, below):
            over, under = _term(above), _term(below)
            return Term(over.number / under.number, over.factors + under.below, over.below + under.factors)
        case Power(base, exponent):
            return Term(1.0, (base,) * exponent)
        case _:
            return Term(1.0, (expression,))


def _product(terms: Sequence[Term]) -> Expression:
    """Return a sum of terms as a product: the common factors of all terms times the sum of what remains."""
    terms = _merged(terms)
    if len(terms) < 2:
        return _plain(terms)
    shared = _shared(terms)
    rest = [term.without(shared) for term in terms]
    square = _square(rest)
    grouped = _grouped(rest) if square is None else [square]
    again = _shared(grouped) if len(grouped) > 1 else Term(1.0, ())
    inner = _plain([term.without(again) for term in grouped])
    common = Term(shared.number * again.number, (*shared.factors, *again.factors), (*shared.below, *again.below))
    return Term(common.number, (*common.factors, inner), common.below).as_formula if inner != ONE else common.as_formula


def _crosswise(terms: Sequence[Term]) -> Expression | None:
    """Return a sum with four of its terms factored as (a + b)(c + d); None if no four terms allow it."""
    for four in combinations(range(len(terms)), 4) if 4 <= len(terms) <= MAX_CROSS_TERMS else ():
        first, *others = (terms[n] for n in four)
        for last in range(3):
            second, third = (others[n] for n in range(3) if n != last)
            sums = _two_sums(first, second, third, others[last])
            if sums is not None:
                rest = [term for n, term in enumerate(terms) if n not in four]
                return _plain([Term(first.number, sums)]) + min((_plain(rest), _product(rest)), key=latex_length)
    return None


def _two_sums(ac: Term, ad: Term, bc: Term, bd: Term) -> tuple[Expression, ...] | None:
    """Return four terms as factors, two of them sums: (a + b) and (c + d); None if the terms allow no such product."""
    over, beside = bc.number / ac.number, ad.number / ac.number  # ratios b/a and d/c
    if any(term.below for term in (ac, ad, bc, bd)) or bd.number != ac.number * over * beside:
        return None
    a = _both(ac.factors, ad.factors)
    c, d = _less(ac.factors, a), _less(ad.factors, a)
    b = _both(bc.factors, bd.factors)
    products = (a + c, ac), (a + d, ad), (b + c, bc), (b + d, bd)
    if not (a and b and c and d) or any(_less(one, t.factors) or _less(t.factors, one) for one, t in products):
        return None
    shared = _both(a, b)
    one = _plain([Term(1.0, _less(a, shared)), Term(over, _less(b, shared))])
    other = _plain([Term(1.0, c), Term(beside, d)])
    return *shared, *sorted((one, other), key=is_difference)


def _square(terms: Sequence[Term]) -> Term | None:
    """Return three terms n(a² + b² ± 2ab) as a multiple of a square; None for any other three."""
    for n, mixed in enumerate(terms if len(terms) == 3 else ()):
        first, second = (*terms[:n], *terms[n + 1 :])
        one, other = _root(first, first.number), _root(second, first.number)
        if one is None or other is None:
            continue
        both = Term(2.0 * first.number * other.number, one.factors + other.factors, one.below + other.below)
        if _like(mixed, both) and isclose(abs(mixed.number), abs(both.number)):
            signed = replace(other, number=copysign(other.number, mixed.number * first.number))
            return Term(first.number, (_plain([one, signed]),) * 2)
    return None


def _root(term: Term, over: float) -> Term | None:
    """Return the positive square root of a term over a number; None if it is not simple."""
    number = sqrt(max(term.number / over, 0.0))
    if simple_fraction(number) is None or not number:
        return None
    if any(side.count(factor) % 2 for side in (term.factors, term.below) for factor in side):
        return None
    return Term(number, _halved(term.factors), _halved(term.below))


def _halved(factors: Sequence[Expression]) -> tuple[Expression, ...]:
    """Return the factors of a square root: each factor half as often as in the product."""
    return tuple(factor for factor in dict.fromkeys(factors) for _ in range(factors.count(factor) // 2))


def _grouped(terms: Sequence[Term]) -> list[Term]:
    """Combine the terms that share the factor with the largest saving, and repeat while terms share factors."""
    gains = {
        factor: (sum(factor in term.factors for term in terms) - 1) * len(factor.latex())
        for term in terms
        for factor in term.factors
    }
    best = max(gains, key=lambda factor: gains[factor], default=None)
    if best is None or not gains[best]:
        return [*terms]
    group, others = ([t for t in terms if (best in t.factors) is inside] for inside in (True, False))
    return _grouped([_term(_product(group)), *others])


def _shared(terms: Sequence[Term]) -> Term:
    """Return the common factors of all terms, and their common number with the sign of the first."""
    first, *others = terms
    factors = reduce(lambda kept, term: _both(kept, term.factors), others, first.factors)
    below = reduce(lambda kept, term: _both(kept, term.below), others, first.below)
    same = len({abs(term.number) for term in terms}) == 1
    negative = all(term.number < 0.0 for term in terms)
    return Term((abs(first.number) if same else 1.0) * (-1.0 if negative else 1.0), factors, below)


def _merged(terms: Sequence[Term]) -> list[Term]:
    """Return terms with like terms combined."""
    merged: list[Term] = []
    for term in terms:
        like = next((n for n, other in enumerate(merged) if _like(term, other)), None)
        if like is None:
            merged.append(term)
        else:
            merged[like] = Term(merged[like].number + term.number, term.factors, term.below)
    return [term for term in merged if term.number]


def _plain(terms: Sequence[Term]) -> Expression:
    """Return the sum of terms as a formula."""
    return reduce(sum_terms, (term.as_formula for term in terms), ZERO)


def _like(one: Term, other: Term) -> bool:
    """Return whether two terms differ in their numbers alone."""
    sides = (one.factors, other.factors), (one.below, other.below)
    return all(len(a) == len(b) and not _less(a, b) for a, b in sides)


def _both(one: Sequence[Expression], other: Sequence[Expression]) -> tuple[Expression, ...]:
    """Return the multiset intersection of two lists of factors."""
    return tuple(factor for n, factor in enumerate(one) if [*one[:n]].count(factor) < [*other].count(factor))


def _less(one: Sequence[Expression], other: Sequence[Expression]) -> tuple[Expression, ...]:
    """Return the multiset difference of two lists of factors."""
    left = [*one]
    for factor in other:
        if factor in left:
            left.remove(factor)
    return tuple(left)


def _raised(factors: Sequence[Expression]) -> Iterator[Expression]:
    """Yield each distinct factor with its power."""
    for factor in dict.fromkeys(factors):
        times = factors.count(factor)
        yield Power(factor, times) if times > 1 else factor
