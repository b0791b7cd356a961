"""What simplifications do to an answer."""

from collections.abc import Iterator
from dataclasses import dataclass

from sim2reason.filters import Candidate
from sim2reason.questions import Study
from sim2reason.questions.simplifications import SIMPLIFICATIONS, ChangedMechanism, OtherReading, Simplification
from sim2reason.questions.tolerance import NEARLY

SAME = 0.02  # of the tolerance: an answer that changes by less is the same
LONGER = 3.0  # times: how much longer a motion is followed whose answer does not come in time


@dataclass(frozen=True, slots=True)
class Effect:
    """What one simplification of one part of the scene does to the answer."""

    simplification: Simplification
    subject: str
    answer: float | None  # None if there is none any more
    change: float  # relative; infinite if there is no answer
    tolerance: float
    study: Study | None  # the scene as it has it; None if there is no motion then

    @property
    def same(self) -> bool:
        """Whether the answer stays what it was."""
        return self.change < SAME * self.tolerance

    @property
    def close(self) -> bool:
        """Whether the answer would be paid, or nearly."""
        return self.change < NEARLY * self.tolerance

    @property
    def wrong(self) -> bool:
        """Whether who makes it errs; nobody does by an approximation that holds."""
        return not (self.same and self.simplification.sound_if_same)

    @property
    def told(self) -> str:
        """In a line."""
        about = f" ({self.subject})" if self.subject else ""
        if self.answer is None:
            return f"{self.simplification.name}{about}: there is no answer any more"
        return f"{self.simplification.name}{about}: {self.answer:.4g}, {self.change:.2g} of the answer away"


def effects(candidate: Candidate, *, part: bool) -> Iterator[Effect]:
    """Those of all simplifications that take a `part` of the scene away, or of all that do not, that filters look at.

    What the question itself speaks of stays as it is. What such answers by nature do not depend on may well be left
    out, as how it begins of the period of small oscillations: that is no slip.
    """
    query, study = candidate.question.query, candidate.study
    asked, until = _asked(candidate), _until(candidate)
    for simplification in SIMPLIFICATIONS.values():
        if not simplification.filtered or simplification.part != part or _is_beside(simplification, candidate):
            continue
        for subject in simplification.subjects(query, study):
            if subject in asked:
                continue
            other = simplification.simplified(study, subject, until)
            effect = _effect(simplification, subject, candidate, other, candidate.response(other))
            if other is None or part or not (effect.same and candidate.kind.indifferent(query, study, other)):
                yield effect


def unfiltered_effects(candidate: Candidate) -> Iterator[Effect]:
    """Those of simplifications that filters do not look at, also of what the question speaks of; each takes time."""
    if _is_of_no_motion(candidate):
        return
    offered = [found for found in SIMPLIFICATIONS.values() if not found.filtered]
    for simplification in sorted(offered, key=lambda found: isinstance(found, OtherReading)):
        for subject in simplification.subjects(candidate.question.query, candidate.study):
            other = simplification.simplified(candidate.study, subject, _until(candidate))
            yield _effect(simplification, subject, candidate, other, candidate.response(other))


def far_effects(candidate: Candidate) -> Iterator[Effect]:
    """Those of all that is another mechanism, followed for longer, with answers far from the right one; they cost most.

    First those of simplifications that filters do not look at.
    """
    query, study = candidate.question.query, candidate.study
    asked, until = _asked(candidate), LONGER * _until(candidate)
    for simplification in sorted(SIMPLIFICATIONS.values(), key=lambda found: found.filtered):
        if isinstance(simplification, ChangedMechanism):
            for subject in simplification.subjects(query, study):
                if not (simplification.filtered and subject in asked):
                    other = simplification.simplified(study, subject, until)
                    yield _effect(simplification, subject, candidate, other, candidate.far_response(other))


def _effect(
    simplification: Simplification, subject: str, candidate: Candidate, other: Study | None, answer: float | None
) -> Effect:
    return Effect(simplification, subject, answer, candidate.change_to(answer), candidate.tolerance, other)


def _asked(candidate: Candidate) -> set[str]:
    """What the question itself speaks of."""
    query = candidate.question.query
    return {query.subject, *(query.moment.subjects if query.moment is not None else ())} - {""}


def _until(candidate: Candidate) -> float:
    return candidate.until if candidate.until is not None else float(candidate.study.trace.state.times[-1])


def _is_beside(simplification: Simplification, candidate: Candidate) -> bool:
    """Whether it reads a motion otherwise, which the answer has nothing to do with."""
    return isinstance(simplification, OtherReading) and _is_of_no_motion(candidate)


def _is_of_no_motion(candidate: Candidate) -> bool:
    """Whether the answer follows from the scene alone, as a threshold does, whatever motion is recorded."""
    return candidate.question.query.moment is None and candidate.time == 0.0
