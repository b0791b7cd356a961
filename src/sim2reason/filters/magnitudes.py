"""Drops a scene with numbers that no textbook would print."""

from collections.abc import Iterator

from sim2reason.dsl.magnitudes import implausible_numbers
from sim2reason.filters import FILTERS, Candidate, Filter


class Magnitudes(Filter):
    """A stated number, a density, a ratio of masses or the length of a spring at the start is not plausible."""

    order = 0
    of_scene = True

    def reason(self, candidate: Candidate) -> str:
        """Look up all stated numbers, once for each scene."""
        study = candidate.study
        return study.once("implausible numbers", lambda: next(implausible_numbers(study.scene), ""))

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield all that is not plausible."""
        return implausible_numbers(candidate.study.scene)


FILTERS.add("magnitudes", Magnitudes())
