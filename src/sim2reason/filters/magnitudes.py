"""Drops a scene with numbers that no textbook would print."""

from collections.abc import Iterator

from sim2reason.dsl.magnitudes import implausible_numbers
from sim2reason.filters import FILTERS, Candidate, SceneFilter
from sim2reason.questions import Study


class Magnitudes(SceneFilter):
    """A stated number, a density, a ratio of masses or the length of a spring at the start is not plausible."""

    def scene_reason(self, study: Study) -> str:
        """Look up all stated numbers, once for each scene."""
        return study.once("implausible numbers", lambda: next(implausible_numbers(study.scene), ""))

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield all that is not plausible."""
        return implausible_numbers(candidate.study.scene)


FILTERS.add("magnitudes", Magnitudes())
