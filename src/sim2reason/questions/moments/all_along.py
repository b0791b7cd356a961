"""Any time after the start, of what never changes."""

from dataclasses import dataclass

from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.at_start import AtStart
from sim2reason.questions.words import Words


@MOMENTS.register("all_along")
@dataclass(frozen=True, slots=True)
class AllAlong(AtStart):
    """Any time after the start, of what never changes: it is read at the start."""

    label = "all along"

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: after release."""
        if words.released:
            return ("after release", "after the release", "in the motion after release")
        return ("during the motion", "throughout the motion", "while the motion lasts")
