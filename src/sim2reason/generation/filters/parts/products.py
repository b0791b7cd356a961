"""Answers that are products of stated numbers: the powers are measured, the factor in front must be a simple one."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product
from math import cos, isclose, log, pi, prod, radians, sin, sqrt, tan

from sim2reason.generation.filters import Candidate
from sim2reason.generation.filters.parts.numbers import SHIFT, givens, shifted
from sim2reason.questions import Question
from sim2reason.scenes.dsl.units import parse_unit

EXACT = 1e-5  # relative: how well the product must be the answer
NEAR = 5.0 * SHIFT  # how near to a multiple of a half a measured power must be
NOTHING = 2e-3  # a smaller power is none; shifted motions tell it to a thousandth
FAR = 5.0  # deg: by how much an angle is turned to see whether it is the function that its power says
HIGHEST = 2.0  # power
SIMPLE = (1.0, 2.0, 4.0, sqrt(2.0), pi, 2.0 * pi)  # factors in front, and their inverses
ANGLE = "deg"
OWN = "what the question states"
View = Callable[[float], float]
"""What of the answer may be a product: itself, or of an angle a trigonometric function."""
VIEWS: dict[str, View] = {
    "": radians,
    "sine": lambda angle: sin(radians(angle)),
    "cosine": lambda angle: cos(radians(angle)),
    "tangent": lambda angle: tan(radians(angle)),
}
POWERS: tuple[tuple[View, View], ...] = (
    (float, lambda _: 1.0),
    (sin, lambda angle: angle / tan(angle)),
    (cos, lambda angle: -angle * tan(angle)),
    (tan, lambda angle: angle / (sin(angle) * cos(angle))),
)
"""Functions of an angle, rad, each with the power with which it goes with the angle."""


@dataclass(frozen=True, slots=True)
class Factor:
    """A stated number in SI units, and the power with which the answer goes with it."""

    path: str  # empty for one of the question's own
    unit: str
    value: float
    power: float


def product_of(candidate: Candidate) -> str:
    """Return the product of stated numbers that the answer is, in a few words; empty if it is none."""
    question = candidate.question
    views = VIEWS if question.unit == ANGLE else {"": float}
    scale = 1.0 if question.unit == ANGLE else parse_unit(question.unit).factor
    for name, view in views.items():
        factors = factors_of(candidate, view)
        if not factors:
            continue
        for total in _products(factors, candidate, view):
            rest = abs(scale * view(question.answer) / total)
            if any(isclose(rest, known, rel_tol=EXACT) for simple in SIMPLE for known in (simple, 1.0 / simple)):
                what = f"the {name} of the answer" if name else "the answer"
                return f"{what} is a product of {', '.join(factor.path or OWN for factor in factors)}"
    return ""


def _products(factors: Sequence[Factor], candidate: Candidate, view: View) -> Iterator[float]:
    """Yield what that of all factors may be; those whose powers are no multiples of a half are the terms of one sum."""
    each = [list(_plain(factor, candidate, view)) for factor in factors]
    terms = [factor for factor, plain in zip(factors, each, strict=True) if not plain]
    rest = _sum(terms) if terms else 1.0
    if rest is not None:
        yield from (rest * prod(some) for some in product(*(plain for plain in each if plain)))


def _sum(terms: Sequence[Factor]) -> float | None:
    """Return a power of a sum of all terms, with either sign; None if their powers are not those of one."""
    rates = [term.power / term.value for term in terms]  # of (Σ ± x)^E the power of x is ± E x/Σ
    alike = max(map(abs, rates)) <= (1.0 + 4.0 * NEAR) * min(map(abs, rates))
    if not alike or len({term.unit for term in terms}) > 1:
        return None
    of_all = sum(term.value if rate * rates[0] > 0.0 else -term.value for term, rate in zip(terms, rates, strict=True))
    return abs(of_all) ** (round(2.0 * sum(term.power for term in terms)) / 2.0) if of_all else None


def _plain(factor: Factor, candidate: Candidate, view: View) -> Iterator[float]:
    """What a number may be as a factor, by its power, a multiple of a half; an angle, by that of a function of it."""
    if factor.unit != ANGLE:
        halves = _halves(factor.power)
        yield from [factor.value ** (halves / 2.0)] if halves else []
        return
    for function, power in POWERS:
        halves = _halves(factor.power / power(factor.value))
        if halves and _goes_with(
            candidate, view, factor, lambda angle, f=function, h=halves: abs(f(angle)) ** (h / 2.0)
        ):
            yield abs(function(factor.value)) ** (halves / 2.0)


def _goes_with(candidate: Candidate, view: View, angle: Factor, function: View) -> bool:
    """Whether what is seen of the answer goes with a function of an angle of the scene, as far as that is turned."""
    if not angle.path:
        return True
    found = turned(candidate, angle)
    if found is None:
        return False
    turn, there = found
    ratio = function(angle.value + turn) / function(angle.value)
    return isclose(view(there) / view(candidate.question.answer), ratio, rel_tol=NEAR)


def turned(candidate: Candidate, angle: Factor) -> tuple[float, float] | None:
    """An angle of the scene turned by `FAR`, rad, the other way if that leaves no answer; None if neither leaves one.

    With the answer there.
    """
    study = candidate.study
    for turn in (FAR, -FAR):
        values = {angle.path: float(study.scene.value(angle.path)) + turn}
        there = candidate.response(study.with_values(values, candidate.until))
        if there is not None:
            return radians(turn), there
    return None


def _halves(power: float) -> int | None:
    """Twice a power, which is a small multiple of a half; None if it is not."""
    found = round(2.0 * power)
    return found if abs(2.0 * power - found) <= 2.0 * NEAR and abs(power) <= HIGHEST + NEAR else None


def factors_of(candidate: Candidate, view: View) -> list[Factor] | None:
    """The numbers on which what is seen of the answer hangs; None if one is a vector, or the answer is lost with it."""
    study, question, found = candidate.study, candidate.question, list[Factor]()
    for given in givens(study.scene, question.left_open):
        other = shifted(study, given, candidate.until)
        there = candidate.response(other)
        if other is None or there is None:
            return None
        first = given.paths[0]
        here, new = (float(scene.value(first)) for scene in (study.scene, other.scene))
        power = _power(view(question.answer), view(there), new / here)
        if power is None or (power and len(given.paths) > 1):
            return None
        found.append(Factor(first, given.unit, _in_si(here, given.unit), power))
    own = _of_question(candidate, view)
    return [factor for factor in (*found, *own) if factor.power] if own is not None else None


def _of_question(candidate: Candidate, view: View) -> list[Factor] | None:
    """Return those that the question itself states; None if the answer is lost with one."""
    question, found = candidate.question, list[Factor]()
    rate = _rate(question, view)
    if question.unknown and question.given is not None:
        own = question.given
        found.append(Factor("", own.unit, _in_si(own.value, own.unit), rate))
    moment = question.query.moment
    if moment is None:
        return found
    for place, (number, unit) in enumerate(moment.stated):
        numbers = [value * (1.0 + SHIFT * (n == place)) for n, (value, _) in enumerate(moment.stated)]
        there = candidate.kind.answer(replace(question.query, moment=moment.having(numbers)), candidate.study)
        if there is None:
            return None
        shown = float if question.unknown else view
        power = _power(shown(question.result), shown(there), 1.0 + SHIFT)
        if power is None:
            return None
        power = -power * rate if question.unknown else power
        found.append(Factor("", unit, _in_si(number, unit), power))
    return found


def _rate(question: Question, view: View) -> float:
    """With which power what is seen of an unknown goes with the result that is given; 0 where it changes its sign."""
    seen = _power(view(question.answer), view(question.answer * (1.0 + SHIFT)), 1.0 + SHIFT)
    return (seen or 0.0) / question.elasticity


def _power(here: float, there: float, factor: float) -> float | None:
    """Return that with which something goes with a number that is taken times a factor; None if it changes its sign."""
    if not there / here > 0.0:
        return None
    power = log(there / here) / log(factor)
    return power if abs(power) > NOTHING else 0.0


def _in_si(value: float, unit: str) -> float:
    """Return a number in SI units; an angle in radians."""
    return value * parse_unit(unit).factor
