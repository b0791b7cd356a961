"""Drops a question about a motion, or with an answer, that is beyond all experience."""

from collections.abc import Iterator

import numpy as np

from sim2reason.dsl.magnitudes import BENCH, FLIGHT, Span, natural_lengths, outside, strained
from sim2reason.dsl.measures import join_unit
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import State
from sim2reason.dsl.units import parse_unit
from sim2reason.filters import FILTERS, Candidate, Filter


class PlausibleOutcome(Filter):
    """The answer, or the result that is given, is not plausible; or a spring is squeezed or stretched too far."""

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """Compare both with the table, and springs with their natural lengths until the moment that is asked about."""
        return next(self.findings(candidate), "")

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield all that is not plausible."""
        question, mechanism = candidate.question, candidate.study.mechanism
        yield from _implausible("the answer", question.answer, question.unit, mechanism)
        if question.given is not None:
            yield from _implausible("the given result", question.given.value, question.given.unit, mechanism)
        natural = natural_lengths(candidate.study.scene)
        if natural:
            yield from strained(natural, mechanism, _lengths(candidate, tuple(natural)))


def _implausible(what: str, value: float, unit: str, mechanism: Mechanism) -> Iterator[str]:
    name = parse_unit(unit).name
    span = (FLIGHT if mechanism.burns else BENCH).get(name)
    if span is not None and outside(value, span):
        yield f"{what} is {join_unit(f'{value:.3g}', name)}"


def _lengths(candidate: Candidate, names: tuple[str, ...]) -> dict[str, Span]:
    """The least and the greatest lengths of some springs until all has happened that the answer depends on, m."""
    trace, time = candidate.study.trace, candidate.time
    state = trace.scan if time is None else trace.sample(_instants(trace.scan, time))
    lines = (line for line in state.mechanism.lines if line.name in names and line.circle is None)
    found = ((line.name, np.asarray(state.frames.length(line))) for line in lines)
    return {name: (float(lengths.min()), float(lengths.max())) for name, lengths in found}


def _instants(state: State, time: float) -> np.ndarray:
    earlier = state.times[state.times < time]
    return np.append(earlier, time)


FILTERS.add("outcome", PlausibleOutcome())
