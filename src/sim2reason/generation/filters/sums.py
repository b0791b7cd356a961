"""Detection of answers that are sums of two products, or their roots, as ½ k d² + ½ m v² or √(v² + 2 g h)."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import product, takewhile
from math import isclose, prod, sqrt
from typing import NamedTuple

from sim2reason.generation.filters import Candidate
from sim2reason.generation.filters.products import (
    ANGLE,
    OWN,
    POWER_TOLERANCE,
    POWERS,
    PRODUCT_RTOL,
    Factor,
    View,
    change_angle,
    find_factors,
)
from sim2reason.scenes.dsl.units import parse_unit

MAX_NUMBERS = 5  # numbers; a sum of two products of more is not common knowledge
ANSWER_POWERS = (1.0, 2.0)  # powers of the answer that may be the sum
MAX_POWER = 4.0  # power of a number in a product
ANGLE_RTOL = 1e-4  # relative deviation of the sum from the answer when an angle is changed
SHARE_TOLERANCE = 0.02  # relative accuracy of a measured share
MAX_ASSIGNMENTS = 256  # distributions of the numbers over the terms, at most
SIMPLE = (1.0, 2.0, 4.0, 0.5, 0.25, sqrt(2.0), sqrt(0.5))  # factors in front of a product


class _TermPowers(NamedTuple):
    """A number, or a function of it, with its exponents in the first and in the second of two products."""

    factor: Factor
    function: View
    powers: tuple[float, float]
    value: tuple[float, float]  # what it is there

    def at(self, turned: float) -> tuple[float, float]:
        """Return the number's factors in the first and second product, after its angle is turned by `turned`, rad."""
        turn = turned if self.factor.unit == ANGLE and self.factor.path else 0.0
        return _raised(self.function(self.factor.value + turn), self.powers)


Terms = Sequence[_TermPowers]
_NumberFunction = tuple[View, float, float | None]


def find_sum(candidate: Candidate) -> str:
    """Return in a few words the sum of two products of stated numbers that equals the answer; empty if none does."""
    question = candidate.question
    factors = find_factors(candidate, float) if question.unit != ANGLE else None
    if not factors or not 2 < len(factors) <= MAX_NUMBERS:
        return ""
    value = abs(question.answer) * parse_unit(question.unit).factor
    for root in ANSWER_POWERS:
        for share, terms in _terms(factors, root):
            if any(_holds_turned(candidate, root, terms, front) for front in _fronts(value**root, share, terms)):
                names = ", ".join(factor.path or OWN for factor in factors)
                return f"the answer is {'the root of ' if root > 1.0 else ''}a sum of two products of {names}"
    return ""


def _fronts(value: float, share: float, terms: Terms) -> Iterator[tuple[float, float]]:
    """Yield simple factors, such as ±½, of two products whose sum is a value; `share` is the first one's part of it."""
    first, second = _multiplied(term.value for term in terms)
    ones = _simple(first, share * value)
    if not ones:  # as nearly always
        return
    for one, other in product(ones, _simple(second, (1.0 - share) * value)):
        if isclose(one * first + other * second, value, rel_tol=PRODUCT_RTOL):
            yield one, other


def _simple(term: float, part: float) -> list[float]:
    """Return the simple factors, such as ½ or 2, with which a product approximately equals part of a value."""
    size, sign = abs(part), -1.0 if part < 0.0 else 1.0
    return [sign * front for front in SIMPLE if isclose(front * term, size, rel_tol=SHARE_TOLERANCE)]


def _holds_turned(candidate: Candidate, root: float, terms: Terms, front: tuple[float, float]) -> bool:
    """Return whether the sum still equals the answer when an angle changes, since 60° alone is ambiguous."""
    for angle in (term.factor for term in terms if term.factor.unit == ANGLE and term.factor.path):
        rotation = change_angle(candidate, angle)
        if rotation is None:
            return False
        turn, there = rotation
        here = _added((term.value for term in terms), front)
        ratio = _added((term.at(turn) for term in terms), front) / here
        if not isclose((there / candidate.question.answer) ** root, ratio, rel_tol=ANGLE_RTOL):
            return False
    return True


def _terms(factors: Sequence[Factor], root: float) -> Iterator[tuple[float, Terms]]:
    """Yield pairs of products that may add up to the answer (or its square), with the first one's share of the sum.

    In Z = A + B, the elasticity of Z in x is q A/Z if x^q is in A, q (1 − A/Z) if it is in B, and q if it is in both.
    """
    ways = [(factor, _ways(factor, root)) for factor in factors]
    for mixed in (factor for factor in factors if not _half(root * factor.power, POWER_TOLERANCE)):
        for _, slope in _shapes(mixed):
            for halves in range(1, round(2.0 * MAX_POWER) + 1):
                for share in (2.0 * root * mixed.power / (sign * halves * slope) for sign in (1.0, -1.0)):
                    places = [*takewhile(bool, (_places(*each, share) for each in ways))]
                    if len(places) == len(factors) and prod(map(len, places)) <= MAX_ASSIGNMENTS:
                        yield from ((share, each) for each in product(*places))


def _multiplied(values: Iterable[tuple[float, float]]) -> tuple[float, float]:
    first = second = 1.0
    for one, other in values:
        first, second = first * one, second * other
    return first, second


def _added(values: Iterable[tuple[float, float]], front: tuple[float, float]) -> float:
    return sum(factor * term for factor, term in zip(front, _multiplied(values), strict=True))


def _ways(factor: Factor, root: float) -> list[_NumberFunction]:
    """Return the possible functions of a number, each with the answer's power in it and the nearest multiple of ½."""
    powers = [(function, root * factor.power / slope) for function, slope in _shapes(factor)]
    return [(function, power, _half(power, POWER_TOLERANCE)) for function, power in powers]


def _places(factor: Factor, ways: Sequence[_NumberFunction], share: float) -> list[_TermPowers]:
    """Return the possible exponents of a number in two products, for a given share of the first in their sum.

    A number may occur in one term, in both, or with a higher power in one, as k does in √(k² d² + k m v²).
    """
    exponents: list[tuple[View, tuple[float, float]]] = []
    for function, power, both in ways:
        if both:
            exponents.append((function, (both, both)))
        for shared in (0.0, 1.0):
            one = _half((power - shared) / share, SHARE_TOLERANCE) if share else None
            other = _half((power - shared) / (1.0 - share), SHARE_TOLERANCE) if share != 1.0 else None
            if one:
                exponents.append((function, (one + shared, shared)))
            if other:
                exponents.append((function, (shared, other + shared)))
    return [
        _TermPowers(factor, function, powers, _raised(function(factor.value), powers)) for function, powers in exponents
    ]


def _raised(value: float, powers: tuple[float, float]) -> tuple[float, float]:
    return abs(value) ** powers[0], abs(value) ** powers[1]


def _shapes(factor: Factor) -> Iterator[tuple[View, float]]:
    """Yield the functions in which a number may occur, such as the sine of an angle, each with its scaling exponent."""
    if factor.unit != ANGLE:
        yield float, 1.0
        return
    yield from ((function, power(factor.value)) for function, power in POWERS[1:])


def _half(power: float, near: float) -> float | None:
    """Return the multiple of one half near a power; None if there is none or it is zero."""
    half = round(2.0 * power) / 2.0
    size = abs(half)
    return half if 0.0 < size <= MAX_POWER and abs(power - half) <= (near * size if size > 1.0 else near) else None
