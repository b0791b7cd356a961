"""Drops a question that pays for a wrong idea."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.filters.parts.effects import effects


class Simplified(Filter):
    """A mistake about the physics changes the answer, but so little that it is paid, or nearly."""

    order = 4

    def reason(self, candidate: Candidate) -> str:
        """Make every mistake that can be made; one that changes nothing claims nothing about the answer."""
        for effect in effects(candidate, part=False):
            if effect.close and not effect.same:
                return f"{effect.simplification.name}: the answer changes by {effect.change:.2g}"
        return ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """What each does to the answer."""
        return (effect.told for effect in effects(candidate, part=False))


FILTERS.add("simplification", Simplified())
