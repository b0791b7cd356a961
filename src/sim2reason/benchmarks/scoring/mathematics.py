"""Answers of AIME and MATH: equal as mathematics, by the library math-verify, in a process that can be killed."""

from sim2reason.benchmarks.scoring import SCORINGS, Award, Reference, Scoring
from sim2reason.benchmarks.scoring.parts.answers import boxes, in_box
from sim2reason.benchmarks.scoring.parts.killable import Killable
from sim2reason.benchmarks.scoring.parts.verify_math import verified
from sim2reason.lazy import cached_property

__all__ = ["MathVerify"]

PATIENCE = 10.0  # s for one answer


class MathVerify(Scoring):
    """By math-verify. Needs: pip install 'sim2reason[eval]'."""

    needs = ("math_verify",)

    @cached_property
    def _verified(self) -> Killable[tuple[bool, bool, str]]:
        return Killable(verified, PATIENCE)

    def award(self, response: str, reference: Reference) -> Award:
        """By the reference's `answer`, a text in LaTeX."""
        self.check()
        found = boxes(response)
        if not found:
            return Award.unreadable("there is no box")
        answer = str(reference["answer"])
        result = self._verified(in_box(answer), in_box(found[-1]))
        if result is None:
            return Award.unreadable(f"math-verify gave no answer within {PATIENCE:g} s")
        readable, equal, _ = result
        return Award(float(equal), readable, found[-1], "" if equal else f"the answer is {answer}")


SCORINGS.add("math", MathVerify())
