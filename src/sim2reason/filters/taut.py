"""Drops a problem whose text calls a string taut that is slack as soon as the motion begins."""

from sim2reason.dsl.mechanism import Inextensible
from sim2reason.filters import FILTERS, Candidate, Filter

SMALL = 1e-9  # N


class Taut(Filter):
    """A string that has nothing to spare at the start pulls at nothing just after it: nobody would call it taut."""

    order = 0
    of_scene = True

    def reason(self, candidate: Candidate) -> str:
        """Look at the tensions just after the start."""
        law, tension = Inextensible(), candidate.study.trace.at(0.0).tension
        slack = [line.name for line in candidate.study.mechanism.strings if line.law == law]
        return next((f"{name} is slack from the start on" for name in slack if tension[name][0] <= SMALL), "")


FILTERS.add("taut", Taut())
