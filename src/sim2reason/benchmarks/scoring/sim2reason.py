"""Our own grader, as the reward: numbers within the item's tolerance and in its unit, formulas by value."""

from sim2reason.benchmarks.scoring import SCORINGS, Award, Reference, Scoring
from sim2reason.datasets.grade import grade_answer
from sim2reason.datasets.item import Answer
from sim2reason.grading import Outcome

__all__ = ["OwnGrader"]

WITHOUT = {Outcome.NO_ANSWER, Outcome.UNREADABLE, Outcome.TOO_LONG}


class OwnGrader(Scoring):
    """By the grader that is the reward, which docs/grading.md describes."""

    def award(self, response: str, reference: Reference) -> Award:
        """By the reference's `answer`, that of an item."""
        score = grade_answer(
            Answer.model_validate(reference["answer"]), response, lenient=bool(reference.get("lenient"))
        )
        parsed = f"{score.parsed:g}" if isinstance(score.parsed, float) else str(score.parsed or "")
        return Award(score.reward, score.outcome not in WITHOUT, parsed, score.why)


SCORINGS.add("sim2reason", OwnGrader())
