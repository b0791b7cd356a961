"""What simplifications do to an answer."""

from collections.abc import Iterator
from dataclasses import dataclass

from sim2reason.filters import Candidate
from sim2reason.questions.simplifications import SIMPLIFICATIONS, Simplification

SAME = 0.02  # of the tolerance: an answer that changes by less is the same
CLOSE = 1.2  # of the tolerance: one that changes by less may be paid, or nearly


@dataclass(frozen=True, slots=True)
class Effect:
    """What one simplification of one part of the scene does to the answer."""

    simplification: Simplification
    subject: str
    answer: float | None  # None if there is none any more
    change: float  # relative; infinite if there is no answer
    tolerance: float

    @property
    def same(self) -> bool:
        """Whether the answer stays what it was."""
        return self.change < SAME * self.tolerance

    @property
    def close(self) -> bool:
        """Whether the answer would be paid, or nearly."""
        return self.change < CLOSE * self.tolerance

    @property
    def told(self) -> str:
        """In a line."""
        about = f" ({self.subject})" if self.subject else ""
        if self.answer is None:
            return f"{self.simplification.name}{about}: there is no answer any more"
        return f"{self.simplification.name}{about}: {self.answer:.4g}, {self.change:.2g} of the answer away"


def effects(candidate: Candidate, *, part: bool) -> Iterator[Effect]:
    """Those of all simplifications that take a `part` of the scene away, or of all that do not.

    What the question itself speaks of stays as it is.
    """
    query, study = candidate.question.query, candidate.study
    asked = {query.subject, *(query.moment.subjects if query.moment is not None else ())} - {""}
    until = candidate.until if candidate.until is not None else float(study.trace.state.times[-1])
    for simplification in SIMPLIFICATIONS.values():
        if simplification.part != part:
            continue
        for subject in simplification.subjects(query, study):
            if subject not in asked:
                answer = candidate.response(simplification.simplified(study, subject, until))
                yield Effect(simplification, subject, answer, candidate.change_to(answer), candidate.tolerance)
