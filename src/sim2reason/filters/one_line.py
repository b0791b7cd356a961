"""Drops a question that one line answers."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.filters.parts.products import product_of


class OneLine(Filter):
    """The answer is no more than a product of a few stated numbers, as m g cos θ, √(2 g h) or F/(m + M) is.

    So is whatever is read off a formula that everybody knows: a period, a free fall, a weight on a slope.
    """

    order = 8

    def reason(self, candidate: Candidate) -> str:
        """See how the answer goes with each number, and whether that is all there is to it."""
        if candidate.kind.measured(candidate.question.query).whole:
            return ""
        return product_of(candidate)

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """The product, if it is one."""
        yield product_of(candidate) or "the answer is no product of stated numbers"


FILTERS.add("one line", OneLine())
