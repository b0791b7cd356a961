"""Filters on the answer and on the agreement of two engines about it."""

import re
from collections.abc import Iterator
from math import sqrt

import numpy as np

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.generation.filters.sensitivity import elasticities, givens
from sim2reason.generation.modes.reverse import why_undetermined
from sim2reason.questions import KINDS
from sim2reason.questions.choices import smallest_answer
from sim2reason.questions.unknown import far_from, range_of
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.measures import join_unit
from sim2reason.simulation.quantities import QUANTITIES, Quantity


class Agreement(Filter):
    """Filter for questions on which the two engines disagree, or whose motion differs before the moment."""

    needs_witness = True
    order = 0

    def reason(self, candidate: Candidate) -> str:
        """Return the reason why the answer is not certified by both engines; empty if it is."""
        query = candidate.question.query
        return KINDS[query.kind].doubt(query, candidate.study, candidate.certificate)

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: the largest difference between the engines, and the end time of the comparison."""
        certificate = candidate.certificate
        if certificate is not None and certificate.agreement:
            worst = max(certificate.agreement, key=lambda channel: certificate.agreement[channel])
            yield (
                f"the worst difference of the engines is {certificate.agreement[worst]:.2g} of the largest value, on "
                f"the {worst.quantity} of {worst.subject}; up to {certificate.tolerance:g} is allowed"
            )
            yield f"they agree until {certificate.stable_until:.4g} s; events that both saw: {len(certificate.matched)}"


FILTERS.add("agreement", Agreement())


MIN_RELATIVE_ANSWER = 0.01  # of the scene's largest value of the quantity: smaller values round to zero in two digits
EQUAL_ANSWER_RTOL = 2e-3  # relative; closer values round to the same three digits


class Degenerate(Filter):
    """Filter for answers that are negative, zero, equal to a stated number, or equal to the initial value."""

    order = 0

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if the answer is negative, (nearly) zero, a number in the text, or the initial value."""
        if (
            candidate.question.formula is not None
            and candidate.question.formula.latex in candidate.question.formula.symbols
        ):
            return "the answer is one symbol"
        if candidate.question.answer < 0.0:
            return "the answer is negative, so that a constant below zero could be right"
        answer = candidate.question.answer
        if abs(candidate.question.result) <= max(_smallest_result(candidate), MIN_RELATIVE_ANSWER * _scale(candidate)):
            return "the answer can not be told from zero"
        nearest = _nearest(candidate)
        if nearest is not None and abs(answer - nearest) <= candidate.tolerance * answer:  # who repeats it is paid
            return "the answer is a stated number"
        return "nothing changes it before" if _lasting(candidate) else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield report lines: the result and the least allowed one, the nearest stated number, the initial value."""
        question, nearest = candidate.question, _nearest(candidate)
        floor = max(_smallest_result(candidate), MIN_RELATIVE_ANSWER * _scale(candidate))
        yield f"the result is {question.result:.4g}; what is not beyond {floor:.2g} can't be told from zero"
        if nearest is not None:
            away, paid = candidate.change_to(nearest), candidate.tolerance
            phrase = f"the nearest number of scene and question is {nearest:g}"
            yield f"{phrase}, {away:.2g} of the answer away; {paid:g} would be paid"
        start = _start(candidate)
        if start is not None:
            yield f"just after the start it is {start:.4g}"


def _smallest_result(candidate: Candidate) -> float:
    """Return the smallest magnitude of a result that does not count as zero."""
    quantity = _asked(candidate)
    if quantity is not None:
        return smallest_answer(candidate.study.mechanism, quantity)
    return KINDS[candidate.question.query.kind].measured(candidate.question.query).least


def _stated(candidate: Candidate, unit: str) -> Iterator[float]:
    """Yield the numbers in the text with this unit; also g and the question's own numbers, whatever their unit."""
    for parameter in candidate.study.scene.parameters:
        open_to_all = not parameter.hidden and parameter.path not in candidate.question.left_open
        alike = parameter.measure.unit == unit or parameter.path.startswith("world.")
        if open_to_all and parameter.value is not None and alike:
            yield parameter.value
    given = candidate.question.given
    if given is not None:
        yield given.value
    moment = candidate.question.query.moment
    yield from (number for number, _ in (moment.stated if moment is not None else ()))


def _nearest(candidate: Candidate) -> float | None:
    """Return the magnitude of the stated number, in the answer's unit, that is nearest to the answer."""
    answer = candidate.question.answer
    sizes = (abs(number) for number in _stated(candidate, candidate.question.unit))
    return min(sizes, key=lambda size: abs(answer - size), default=None)


def _asked(candidate: Candidate) -> Quantity | None:
    """Return the physical quantity asked for; None if the question asks for something else, such as a time."""
    query = candidate.question.query
    if query.target is None or KINDS[query.kind].measured(query).name != query.target.quantity:
        return None
    return QUANTITIES[query.target.quantity]


def _lasting(candidate: Candidate) -> bool:
    """Return whether the answer equals the value of the same quantity just after the start."""
    start, answer = _start(candidate), candidate.question.result
    return start is not None and abs(answer - start) <= EQUAL_ANSWER_RTOL * abs(answer)


def _start(candidate: Candidate) -> float | None:
    """Return the value of the quantity asked about just after the start; None for other questions."""
    query, study = candidate.question.query, candidate.study
    if _asked(candidate) is None or query.target is None or not KINDS[query.kind].time(query, study):
        return None
    return query.target.value(study.trace.sample(np.zeros(1)))


def _scale(candidate: Candidate) -> float:
    """Return the largest value of the quantity asked about, over all bodies and up to the end of the motion."""
    quantity, trace = _asked(candidate), candidate.study.trace
    if quantity is None:
        return 0.0
    state = trace.state
    within = state.times <= trace.stable_until
    largest = 0.0
    for subject in quantity.subjects(state.mechanism):
        values = quantity.evaluate(state, subject)[within]
        size = np.abs(values) if values.ndim == 1 else np.linalg.norm(values, axis=1)
        largest = max(largest, float(np.nanmax(size, initial=0.0)))
    return largest


FILTERS.add("degenerate", Degenerate())


class Identifiable(Filter):
    """Filter for unknowns that the given result does not determine, or that the text does not mention."""

    order = 10

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if the given result does not determine the unknown, or no words of the text mention it."""
        question, words = candidate.question, candidate.words
        if not question.unknown or words is None:
            return ""
        text = " ".join(candidate.sentences)
        if not all(_speaks_of(path, words, text) for path in question.left_open):
            return "the text has no words for the unknown"
        return candidate.study.memoize(
            ("unfixed", question), lambda: why_undetermined(question, candidate.study, words)
        )

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield a report line: in which range no value of the unknown but the answer gives the stated result."""
        question = candidate.question
        if question.unknown and question.given is not None and not self.reason(candidate):
            values = range_of(candidate.study.scene, question.unknown, question.answer)
            values = [*values, *far_from(values, question.answer, question.unit)]
            low, high = (join_unit(f"{value:.3g}", question.unit) for value in (min(values), max(values)))
            yield f"from {low} to {high} no value of {question.unknown} but {question.answer:.4g} gives the result"


def _speaks_of(path: str, words: Words, text: str) -> bool:
    """Return whether a text uses the symbol of a number other than as its own value, as in *R = $R$*."""
    alone = next(unknown.symbol for unknown in words.unknowns if unknown.path == path).strip("$")
    for symbol in (alone, words.symbols.get(path, alone)):
        own = rf"(?<!\w){re.escape(_plain(symbol))} = \${re.escape(symbol)}\$"
        if f"${symbol}$" in text and re.search(own, text) is None:
            return True
    return False


def _plain(symbol: str) -> str:
    """Return a symbol as it is written inline in prose."""
    return {r"\omega": "ω"}.get(symbol, symbol)


FILTERS.add("identifiable", Identifiable())


MAX_CONDITION_NUMBER = 20.0  # condition number: the root of the sum of the squares of all elasticities


class Precision(Filter):
    """Filter for ill-conditioned answers: a small change of a stated number changes the answer or event order a lot.

    Counted answers must not change when any number changes by half a unit in its last place.
    """

    order = 8

    def reason(self, candidate: Candidate) -> str:
        """Return a reason if a shift of the stated numbers by a thousandth changes the answer or event order a lot."""
        squares = 0.0
        for elasticity in elasticities(candidate):
            if elasticity.reordered:
                return f"a small shift of {', '.join(elasticity.given.paths)} changes the order of events"
            squares += elasticity.size**2
            if squares > MAX_CONDITION_NUMBER**2:
                return f"the condition number is at least {sqrt(squares):.1f}"
        changed = next(_miscounted(candidate), "") if candidate.kind.measured(candidate.question.query).whole else ""
        return f"half a unit in the last place of {changed} changes the count" if changed else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield a report line with the condition number: the sensitivity of the answer to the stated numbers."""
        total = sqrt(sum(elasticity.size**2 for elasticity in elasticities(candidate)))
        yield f"the condition number is {total:.2f}; up to {MAX_CONDITION_NUMBER:g} is allowed"


def _miscounted(candidate: Candidate) -> Iterator[str]:
    """Yield the addresses of numbers whose rounding error changes a counted answer."""
    study, question = candidate.study, candidate.question
    for parameter in (parameter for given in givens(study.scene, question.left_open) for parameter in given.parameters):
        value = float(study.scene.value(parameter.path))
        half = 0.5 * 10.0 ** -parameter.measure.places(value)
        others = (study.with_values({parameter.path: value + shift}, candidate.until) for shift in (half, -half))
        if any(other is not None and candidate.response(other) != question.answer for other in others):
            yield parameter.path


FILTERS.add("precision", Precision())
