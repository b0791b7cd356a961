"""Drops a question that is easier or harder than the label that was ordered."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.solutions.difficulty import LABELS

TOO_EASY, TOO_HARD = "too easy", "too hard"
COUNTED = frozenset({f"difficulty: {TOO_EASY}", f"difficulty: {TOO_HARD}"})
"""Under which names a manifest counts what it refuses."""


class FitsLabel(Filter):
    """The score of the shortest solution, or of those of all parts together, lies outside the band of the label.

    Nothing is said of a question of no label, or one that only an integration answers.
    """

    order = 5

    def ready(self, candidate: Candidate) -> bool:
        """Return whether the shortest solution is cached; if so, this filter is cheap enough to run first."""
        return candidate.is_solved

    def reason(self, candidate: Candidate) -> str:
        """Compare the score with the band."""
        if not candidate.labelled or candidate.measured is None:
            return ""
        score, band = candidate.measured.score, LABELS[candidate.difficulty]
        if score in band:
            return ""
        return f"{TOO_HARD if score > band.most else TOO_EASY}: a score of {score} for {candidate.difficulty}"

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """What is measured."""
        found = candidate.measured
        if found is not None:
            yield f"laws {found.laws}, phases {found.phases}, unknowns together {found.unknowns}, score {found.score}"


FILTERS.add("difficulty", FitsLabel())
