"""Drops a problem whose text calls a string taut that is slack as soon as the motion begins."""

from collections.abc import Iterator

from sim2reason.dsl.measures import join_unit
from sim2reason.dsl.mechanism import Inextensible
from sim2reason.filters import FILTERS, Candidate, SceneFilter
from sim2reason.questions import Study

SMALL = 1e-9  # N


class Taut(SceneFilter):
    """A string that has nothing to spare at the start pulls at nothing just after it: nobody would call it taut."""

    def scene_reason(self, study: Study) -> str:
        """Return the first string whose tension is zero just after the start."""
        return next((f"{name} is slack from the start on" for name, t in _tensions(study).items() if t <= SMALL), "")

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """The least tension."""
        tensions = _tensions(candidate.study)
        if tensions:
            name = min(tensions, key=lambda each: tensions[each])
            unit = candidate.study.mechanism.units.spell("N")
            yield f"the least tension just after the start is {join_unit(f'{tensions[name]:.4g}', unit)}, in {name}"


def _tensions(study: Study) -> dict[str, float]:
    """Return the tensions of all strings just after the start, N."""
    law, tension = Inextensible(), study.trace.at(0.0).tension
    return {line.name: float(tension[line.name][0]) for line in study.mechanism.strings if line.law == law}


FILTERS.add("taut", Taut())
