"""One number within a relative tolerance, in the reference's unit where that is known: for books of problems."""

from typing import cast

from sim2reason.benchmarks.scoring import SCORINGS, Award, Reference, Scoring
from sim2reason.datasets.item import Answer
from sim2reason.grading import Outcome, number

__all__ = ["Numeric"]

TOLERANCE = Answer.model_fields["tolerance"].default
WITHOUT = {Outcome.NO_ANSWER, Outcome.UNREADABLE, Outcome.TOO_LONG}


class Numeric(Scoring):
    """One number within 5 %, or the tolerance of the reference, relative to it: 0 is right for 0 alone."""

    def award(self, response: str, reference: Reference) -> Award:
        """By the reference's `value`, `unit` (None: not known) and `tolerance`."""
        value, unit = cast("float", reference["value"]), cast("str | None", reference.get("unit"))
        tolerance = cast("float", reference.get("tolerance", TOLERANCE))
        score = number(response, value, unit, tolerance=tolerance, lenient=bool(reference.get("lenient")))
        parsed = f"{score.parsed:g}" if isinstance(score.parsed, float) else ""
        return Award(score.reward, score.outcome not in WITHOUT, parsed, score.why)


SCORINGS.add("numeric", Numeric())
