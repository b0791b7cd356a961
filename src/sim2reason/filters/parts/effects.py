"""What simplifications do to an answer."""

from collections.abc import Iterator
from dataclasses import dataclass

from sim2reason.filters import Candidate
from sim2reason.questions import Study
from sim2reason.questions.simplifications import SIMPLIFICATIONS, OtherReading, Simplification
from sim2reason.questions.tolerance import NEARLY

SAME = 0.02  # of the tolerance: an answer that changes by less is the same


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
    """Those of all simplifications that take a `part` of the scene away, or of all that do not.

    What the question itself speaks of stays as it is. What such answers by nature do not depend on may well be left
    out, as how it begins of the period of small oscillations: that is no slip.
    """
    query, study = candidate.question.query, candidate.study
    asked = {query.subject, *(query.moment.subjects if query.moment is not None else ())} - {""}
    until = candidate.until if candidate.until is not None else float(study.trace.state.times[-1])
    for simplification in SIMPLIFICATIONS.values():
        if simplification.part != part or (isinstance(simplification, OtherReading) and _is_of_no_motion(candidate)):
            continue
        for subject in simplification.subjects(query, study):
            if subject in asked:
                continue
            other = simplification.simplified(study, subject, until)
            answer = candidate.response(other)
            effect = Effect(simplification, subject, answer, candidate.change_to(answer), candidate.tolerance, other)
            if other is None or part or not (effect.same and candidate.kind.indifferent(query, study, other)):
                yield effect


def _is_of_no_motion(candidate: Candidate) -> bool:
    """Whether the answer follows from the scene alone, as a threshold does, whatever motion is recorded."""
    return candidate.question.query.moment is None and candidate.time == 0.0
