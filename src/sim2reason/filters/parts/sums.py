"""Answers that are sums of two products of stated numbers, or roots of such, as ½ k d² + ½ m v² or √(v² + 2 g h)."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product, takewhile
from math import isclose, prod, sqrt

from sim2reason.dsl.units import parse_unit
from sim2reason.filters import Candidate
from sim2reason.filters.parts.products import ANGLE, EXACT, NEAR, OWN, POWERS, Factor, View, factors_of, turned

MOST = 5  # numbers: of more a sum of two products is none that everybody knows
ROOTS = (1.0, 2.0)  # powers of the answer that may be the sum
HIGHEST = 4.0  # power of a number in a product
TURNED = 1e-4  # relative: how well it must be that where an angle is turned
CLOSE = 0.02  # relative: how well a share is known from shifted numbers
TRIED = 256  # ways to share out numbers, at most
SIMPLE = (1.0, 2.0, 4.0, 0.5, 0.25, sqrt(2.0), sqrt(0.5))  # factors in front of a product


@dataclass(frozen=True, slots=True)
class _Place:
    """As what a number stands in the first term and in the second: a function of it, to two powers."""

    factor: Factor
    function: View
    powers: tuple[float, float]

    def at(self, turned: float = 0.0) -> tuple[float, float]:
        """What it is there; an angle of the scene if it were turned, rad."""
        turn = turned if self.factor.unit == ANGLE and self.factor.path else 0.0
        value = abs(self.function(self.factor.value + turn))
        return value ** self.powers[0], value ** self.powers[1]


Terms = Sequence[_Place]


def sum_of(candidate: Candidate) -> str:
    """The sum of two products of stated numbers that the answer is, in a few words; empty if it is none."""
    question = candidate.question
    factors = factors_of(candidate, float) if question.unit != ANGLE else None
    if not factors or not 2 < len(factors) <= MOST:
        return ""
    value = abs(question.answer) * parse_unit(question.unit).factor
    for root in ROOTS:
        for share, terms in _terms(factors, root):
            if any(_holds_turned(candidate, root, terms, front) for front in _fronts(value**root, share, terms)):
                names = ", ".join(factor.path or OWN for factor in factors)
                return f"the answer is {'the root of ' if root > 1.0 else ''}a sum of two products of {names}"
    return ""


def _fronts(value: float, share: float, terms: Terms) -> Iterator[tuple[float, float]]:
    """The simple factors, with their signs, with which two terms add up to a value; the first has about a share."""
    found = list[list[float]]()
    for term, part in zip(_multiplied(terms), (share * value, (1.0 - share) * value), strict=True):
        sign = -1.0 if part < 0.0 else 1.0
        found.append([sign * front for front in SIMPLE if isclose(front * term, abs(part), rel_tol=CLOSE)])
    for one, other in product(*found):
        if isclose(_added(terms, (one, other)), value, rel_tol=EXACT):
            yield one, other


def _holds_turned(candidate: Candidate, root: float, terms: Terms, front: tuple[float, float]) -> bool:
    """Whether the answer stays the sum when an angle of the scene is turned: of 60° alone many functions are simple."""
    for angle in (place.factor for place in terms if place.factor.unit == ANGLE and place.factor.path):
        found = turned(candidate, angle)
        if found is None:
            return False
        turn, there = found
        ratio = _added(terms, front, turn) / _added(terms, front)
        if not isclose((there / candidate.question.answer) ** root, ratio, rel_tol=TURNED):
            return False
    return True


def _terms(factors: Sequence[Factor], root: float) -> Iterator[tuple[float, Terms]]:
    """Two products that the answer, to the power of `root`, may be the sum of, and the share of the first.

    In Z = A + B the power of x^q that stands in A is q A/Z, of one in B q (1 - A/Z), of one in both q.
    """
    for mixed in (factor for factor in factors if not _half(root * factor.power, NEAR)):
        for _, slope in _shapes(mixed):
            for halves in range(1, round(2.0 * HIGHEST) + 1):
                for share in (2.0 * root * mixed.power / (sign * halves * slope) for sign in (1.0, -1.0)):
                    places = [*takewhile(bool, (list(_places(factor, root, share)) for factor in factors))]
                    if len(places) == len(factors) and prod(map(len, places)) <= TRIED:
                        yield from ((share, each) for each in product(*places))


def _multiplied(terms: Terms, turned: float = 0.0) -> tuple[float, float]:
    each = [place.at(turned) for place in terms]
    return prod(one for one, _ in each), prod(other for _, other in each)


def _added(terms: Terms, front: tuple[float, float], turned: float = 0.0) -> float:
    return sum(factor * term for factor, term in zip(front, _multiplied(terms, turned), strict=True))


def _places(factor: Factor, root: float, share: float) -> Iterator[_Place]:
    """Where a number may stand, by the power with which the sum goes with it: in one term or both, or once more in one.

    As k does in √(k² d² + k m v²).
    """
    for function, slope in _shapes(factor):
        found = root * factor.power / slope
        both = _half(found, NEAR)
        if both:
            yield _Place(factor, function, (both, both))
        for shared in (0.0, 1.0):
            one, other = (_half((found - shared) / part, CLOSE) if part else None for part in (share, 1.0 - share))
            if one:
                yield _Place(factor, function, (one + shared, shared))
            if other:
                yield _Place(factor, function, (shared, other + shared))


def _shapes(factor: Factor) -> Iterator[tuple[View, float]]:
    """As what a number may stand there: itself or a function, and the power with which that goes with the number."""
    if factor.unit != ANGLE:
        yield float, 1.0
        return
    yield from ((function, power(factor.value)) for function, power in POWERS[1:])


def _half(power: float, near: float) -> float | None:
    """A power, which is a multiple of a half and not zero; None if it is not."""
    found = round(2.0 * power) / 2.0
    return found if 0.0 < abs(found) <= HIGHEST and abs(power - found) <= near * max(1.0, abs(found)) else None
