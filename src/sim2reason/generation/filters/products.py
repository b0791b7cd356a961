"""Detection of answers that are products of powers of stated numbers with a simple factor."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import product
from math import cos, isclose, log, pi, prod, radians, sin, sqrt, tan

from sim2reason.generation.filters import Candidate
from sim2reason.generation.filters.sensitivity import SHIFT_FRACTION, givens, simulate_shifted
from sim2reason.questions import Question
from sim2reason.scenes.dsl.units import parse_unit

PRODUCT_RTOL = 1e-5  # relative deviation between the product and the answer
POWER_TOLERANCE = 5.0 * SHIFT_FRACTION  # deviation of a measured power from a multiple of one half
ZERO_POWER = 2e-3  # smaller powers count as zero
TEST_ANGLE = 5.0  # degrees by which an angle is changed to test the function of it
MAX_POWER = 2.0  # power
SIMPLE = (1.0, 2.0, 4.0, sqrt(2.0), pi, 2.0 * pi)  # factors in front, and their reciprocals
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
    """A stated number in SI units, and the power of it to which the answer is proportional."""

    path: str  # empty for one of the question's own
    unit: str
    value: float
    power: float


def find_product(candidate: Candidate) -> str:
    """Return the product of stated numbers that equals the answer, in a few words; empty if there is none."""
    question = candidate.question
    views = VIEWS if question.unit == ANGLE else {"": float}
    scale = 1.0 if question.unit == ANGLE else parse_unit(question.unit).factor
    for name, view in views.items():
        factors = find_factors(candidate, view)
        if not factors:
            continue
        for total in _products(factors, candidate, view):
            rest = abs(scale * view(question.answer) / total)
            if any(isclose(rest, known, rel_tol=PRODUCT_RTOL) for simple in SIMPLE for known in (simple, 1.0 / simple)):
                what = f"the {name} of the answer" if name else "the answer"
                return f"{what} is a product of {', '.join(factor.path or OWN for factor in factors)}"
    return ""


def _products(factors: Sequence[Factor], candidate: Candidate, view: View) -> Iterator[float]:
    """Yield products of all numbers' powers; the numbers without a simple power enter as a power of their sum."""
    each = [list(_plain(factor, candidate, view)) for factor in factors]
    terms = [factor for factor, plain in zip(factors, each, strict=True) if not plain]
    rest = _sum(terms) if terms else 1.0
    if rest is not None:
        yield from (rest * prod(some) for some in product(*(plain for plain in each if plain)))


def _sum(terms: Sequence[Factor]) -> float | None:
    """Return a power of a signed sum of numbers that explains the measured powers; None if there is none."""
    rates = [term.power / term.value for term in terms]  # of (Σ ± x)^E the power of x is ± E x/Σ
    alike = max(map(abs, rates)) <= (1.0 + 4.0 * POWER_TOLERANCE) * min(map(abs, rates))
    if not alike or len({term.unit for term in terms}) > 1:
        return None
    of_all = sum(term.value if rate * rates[0] > 0.0 else -term.value for term, rate in zip(terms, rates, strict=True))
    return abs(of_all) ** (round(2.0 * sum(term.power for term in terms)) / 2.0) if of_all else None


def _plain(factor: Factor, candidate: Candidate, view: View) -> Iterator[float]:
    """Yield a number raised to its measured power if that is a multiple of ½; of an angle, its sine and so on."""
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
    """Return whether the answer changes in proportion to a function of an angle if the angle is changed by 5°."""
    if not angle.path:
        return True
    rotation = change_angle(candidate, angle)
    if rotation is None:
        return False
    turn, there = rotation
    ratio = function(angle.value + turn) / function(angle.value)
    return isclose(view(there) / view(candidate.question.answer), ratio, rel_tol=POWER_TOLERANCE)


def change_angle(candidate: Candidate, angle: Factor) -> tuple[float, float] | None:
    """Return the change of an angle by 5°, rad, and the answer after it; None if there is no answer for either sign."""
    study = candidate.study
    for turn in (TEST_ANGLE, -TEST_ANGLE):
        values = {angle.path: float(study.scene.value(angle.path)) + turn}
        there = candidate.response(study.with_values(values, candidate.until))
        if there is not None:
            return radians(turn), there
    return None


def _halves(power: float) -> int | None:
    """Return the number of halves in a measured power, 3 for 1.5; None unless it is a small multiple of ½."""
    halves = round(2.0 * power)
    return (
        halves
        if abs(2.0 * power - halves) <= 2.0 * POWER_TOLERANCE and abs(power) <= MAX_POWER + POWER_TOLERANCE
        else None
    )


def find_factors(candidate: Candidate, view: View) -> list[Factor] | None:
    """Return the numbers on which the answer depends, with powers; None for a vector or a missing answer."""
    study, question, factors = candidate.study, candidate.question, list[Factor]()
    for given in givens(study.scene, question.left_open):
        other = simulate_shifted(study, given, candidate.until)
        there = candidate.response(other)
        if other is None or there is None:
            return None
        first = given.paths[0]
        here, new = (float(scene.value(first)) for scene in (study.scene, other.scene))
        power = _power(view(question.answer), view(there), new / here)
        if power is None or (power and len(given.paths) > 1):
            return None
        factors.append(Factor(first, given.unit, _to_si(here, given.unit), power))
    own = _of_question(candidate, view)
    return [factor for factor in (*factors, *own) if factor.power] if own is not None else None


def _of_question(candidate: Candidate, view: View) -> list[Factor] | None:
    """Return the question's own numbers, each with the answer's power in it; None if an answer is missing."""
    question, factors = candidate.question, list[Factor]()
    rate = _rate(question, view)
    if question.unknown and question.given is not None:
        own = question.given
        factors.append(Factor("", own.unit, _to_si(own.value, own.unit), rate))
    moment = question.query.moment
    if moment is None:
        return factors
    for index, (number, unit) in enumerate(moment.stated):
        numbers = [value * (1.0 + SHIFT_FRACTION * (n == index)) for n, (value, _) in enumerate(moment.stated)]
        there = candidate.kind.answer(replace(question.query, moment=moment.having(numbers)), candidate.study)
        if there is None:
            return None
        shown = float if question.unknown else view
        power = _power(shown(question.result), shown(there), 1.0 + SHIFT_FRACTION)
        if power is None:
            return None
        power = -power * rate if question.unknown else power
        factors.append(Factor("", unit, _to_si(number, unit), power))
    return factors


def _rate(question: Question, view: View) -> float:
    """Return the exponent with which the answer scales with the given result of a reverse question."""
    seen = _power(view(question.answer), view(question.answer * (1.0 + SHIFT_FRACTION)), 1.0 + SHIFT_FRACTION)
    return (seen or 0.0) / question.elasticity


def _power(here: float, there: float, factor: float) -> float | None:
    """Return the exponent with which a value scales with a number; None if the value changes its sign."""
    if not there / here > 0.0:
        return None
    power = log(there / here) / log(factor)
    return power if abs(power) > ZERO_POWER else 0.0


def _to_si(value: float, unit: str) -> float:
    """Return a number in SI units; an angle in radians."""
    return value * parse_unit(unit).factor
