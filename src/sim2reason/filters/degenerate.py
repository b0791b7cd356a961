"""Drops a question whose answer is nothing, or stands in the text."""

from collections.abc import Iterator

import numpy as np

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.quantities import QUANTITIES, Quantity
from sim2reason.questions import KINDS
from sim2reason.questions.choices import least

SMALLEST = 0.01  # of the scene's largest value of the quantity: two spoken digits can't tell less from zero
SAME = 2e-3  # relative: what rounds to the same three digits


class Degenerate(Filter):
    """The answer is negative, nothing, one of the stated numbers, or what it was at the start."""

    order = 0

    def reason(self, candidate: Candidate) -> str:
        """Compare the result with zero and with the scene's scale, and the answer with every number of the text."""
        if (
            candidate.question.formula is not None
            and candidate.question.formula.latex in candidate.question.formula.symbols
        ):
            return "the answer is one symbol"
        if candidate.question.answer < 0.0:
            return "the answer is negative, so that a constant below zero could be right"
        answer = candidate.question.answer
        if abs(candidate.question.result) <= max(_least(candidate), SMALLEST * _scale(candidate)):
            return "the answer can not be told from zero"
        near = candidate.tolerance * answer  # who repeats it is paid
        if any(abs(answer - abs(said)) <= near for said in _stated(candidate, candidate.question.unit)):
            return "the answer is a stated number"
        return "nothing changes it before" if _lasting(candidate) else ""


def _least(candidate: Candidate) -> float:
    """The smallest result."""
    quantity = _asked(candidate)
    if quantity is not None:
        return least(candidate.study.mechanism, quantity)
    return KINDS[candidate.question.query.kind].measured(candidate.question.query).least


def _stated(candidate: Candidate, unit: str) -> Iterator[float]:
    """The numbers of a unit in the text of the scene; of any unit g and those of the question, with which it ends."""
    for parameter in candidate.study.scene.parameters:
        open_to_all = not parameter.hidden and parameter.path != candidate.question.unknown
        alike = parameter.measure.unit == unit or parameter.path.startswith("world.")
        if open_to_all and parameter.value is not None and alike:
            yield parameter.value
    given = candidate.question.given
    if given is not None:
        yield given.value
    moment = candidate.question.query.moment
    yield from (number for number, _ in (moment.stated if moment is not None else ()))


def _asked(candidate: Candidate) -> Quantity | None:
    """The quantity that the answer is a value of; None if it is none, such as a time."""
    query = candidate.question.query
    if query.target is None or KINDS[query.kind].measured(query).name != query.target.quantity:
        return None
    return QUANTITIES[query.target.quantity]


def _lasting(candidate: Candidate) -> bool:
    """Whether a quantity at a later moment still has the value that it has just after the start."""
    query, study = candidate.question.query, candidate.study
    quantity, target, answer = _asked(candidate), query.target, candidate.question.result
    if quantity is None or target is None or not KINDS[query.kind].time(query, study):
        return False
    start = target.value(study.trace.sample(np.zeros(1)))
    return abs(answer - start) <= SAME * abs(answer)


def _scale(candidate: Candidate) -> float:
    """The largest value of the asked quantity on any subject while the motion is described."""
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
