"""Drops a question whose answer is nothing, or stands in the text."""

from collections.abc import Iterator

import numpy as np

from sim2reason.filters import FILTERS, Candidate
from sim2reason.quantities import QUANTITIES
from sim2reason.questions.moments import Moved

SMALLEST = 0.01  # of the scene's largest value of the quantity: two spoken digits can't tell less from zero
FLOORS = {"m": 1e-3, "m/s": 1e-2, "m/s^2": 1e-2, "s": 1e-2}
FLOOR = 1e-3
GIVEN = frozenset({"velocity", "momentum", "kinetic energy"})  # at the start, by the text
SAME = 2e-3  # relative: what rounds to the same three digits


class Degenerate:
    """The answer is zero, too small to be told from zero, one of the stated numbers, or what it was at the start."""

    needs_witness = False
    order = 0

    def reason(self, candidate: Candidate) -> str:
        """Compare the answer with zero, with the scene's scale and with every number of the text."""
        answer, unit = abs(candidate.question.answer), candidate.question.unit
        if answer <= max(FLOORS.get(unit, FLOOR), SMALLEST * _scale(candidate)):
            return "the answer can not be told from zero"
        if any(abs(answer - abs(said)) <= SAME * answer for said in _stated(candidate, unit)):
            return "the answer is a stated number"
        return "nothing changes it before" if _lasting(candidate) else ""


def _stated(candidate: Candidate, unit: str) -> Iterator[float]:
    """The numbers of a unit in the text of the scene and in the question."""
    for parameter in candidate.scene.parameters:
        if not parameter.hidden and parameter.value is not None and parameter.measure.unit == unit:
            yield parameter.value
    moment = candidate.question.ask.moment
    if isinstance(moment, Moved) and unit == "m":
        yield moment.distance


def _lasting(candidate: Candidate) -> bool:
    """Whether a quantity that the text gives at the start still has that value."""
    target, answer = candidate.question.ask.target, candidate.question.answer
    if target is None or target.quantity not in GIVEN:
        return False
    start = target.value(candidate.trace.sample(np.zeros(1)))
    return abs(answer - start) <= SAME * abs(answer)


def _scale(candidate: Candidate) -> float:
    """The largest value of the asked quantity on any subject while the motion is described."""
    target, trace = candidate.question.ask.target, candidate.trace
    if target is None:
        return 0.0
    quantity = QUANTITIES[target.quantity]
    state = trace.state
    within = state.times <= trace.stable_until
    largest = 0.0
    for subject in quantity.subjects(state.mechanism):
        values = quantity.evaluate(state, subject)[within]
        size = np.abs(values) if values.ndim == 1 else np.linalg.norm(values, axis=1)
        largest = max(largest, float(np.nanmax(size, initial=0.0)))
    return largest


FILTERS.add("degenerate", Degenerate())
