"""Drops a question whose answer is nothing, or stands in the text."""

from collections.abc import Iterator

import numpy as np

from sim2reason.filters import FILTERS, Candidate
from sim2reason.quantities import QUANTITIES, Quantity
from sim2reason.questions import KINDS

SMALLEST = 0.01  # of the scene's largest value of the quantity: two spoken digits can't tell less from zero
SAME = 2e-3  # relative: what rounds to the same three digits


class Degenerate:
    """The answer is zero, too small to be told from zero, one of the stated numbers, or what it was at the start."""

    needs_witness = False
    order = 0

    def reason(self, candidate: Candidate) -> str:
        """Compare the answer with zero, with the scene's scale and with every number of the text."""
        answer, query = abs(candidate.question.answer), candidate.question.query
        if answer <= max(KINDS[query.kind].measured(query).least, SMALLEST * _scale(candidate)):
            return "the answer can not be told from zero"
        if any(abs(answer - abs(said)) <= SAME * answer for said in _stated(candidate, candidate.question.unit)):
            return "the answer is a stated number"
        return "nothing changes it before" if _lasting(candidate) else ""


def _stated(candidate: Candidate, unit: str) -> Iterator[float]:
    """The numbers of a unit in the text of the scene and in the question."""
    for parameter in candidate.study.scene.parameters:
        if not parameter.hidden and parameter.value is not None and parameter.measure.unit == unit:
            yield parameter.value
    moment = candidate.question.query.moment
    yield from (number for number, of in (moment.stated if moment is not None else ()) if of == unit)


def _asked(candidate: Candidate) -> Quantity | None:
    """The quantity that the answer is a value of; None if it is none, such as a time."""
    query = candidate.question.query
    if query.target is None or KINDS[query.kind].measured(query).name != query.target.quantity:
        return None
    return QUANTITIES[query.target.quantity]


def _lasting(candidate: Candidate) -> bool:
    """Whether a quantity that the text gives at the start still has that value."""
    quantity, target, answer = _asked(candidate), candidate.question.query.target, candidate.question.answer
    if quantity is None or target is None or not quantity.given:
        return False
    start = target.value(candidate.study.trace.sample(np.zeros(1)))
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
