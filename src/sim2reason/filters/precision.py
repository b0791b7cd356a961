"""Drops a question whose answer hangs on digits that the text does not give."""

from collections.abc import Iterator
from math import sqrt

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.filters.parts.numbers import elasticities

WORST = 20.0  # the condition number, the root of the sum of the squares of all elasticities


class Precision(Filter):
    """A small shift of a stated number moves the answer too far, or changes the order of events: chaos."""

    order = 7

    def reason(self, candidate: Candidate) -> str:
        """Shift the stated numbers, one by one, by one part in a thousand and solve again."""
        squares = 0.0
        for found in elasticities(candidate):
            if found.reordered:
                return f"a small shift of {', '.join(found.given.paths)} changes the order of events"
            squares += found.size**2
            if squares > WORST**2:
                return f"the condition number is at least {sqrt(squares):.1f}"
        return ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """The condition number."""
        total = sqrt(sum(found.size**2 for found in elasticities(candidate)))
        yield f"the condition number is {total:.2f}; up to {WORST:g} is allowed"


FILTERS.add("precision", Precision())
