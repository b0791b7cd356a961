"""Drops a question that one line answers."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.filters.parts.products import product_of
from sim2reason.filters.parts.sums import sum_of
from sim2reason.filters.parts.turning import TURNS, turns_by_weight


class OneLine(Filter):
    """The answer is no more than a product of a few stated numbers, or a sum of two, as F/(m + M) or √(v² + 2 g h).

    So is whatever is read off a formula that everybody knows: a period, a free fall, a weight on a slope. What rolls or
    swings by its weight is kept, as by `few laws`: a law of motion and a law of turning hold together there, whatever
    comes out, as the friction ½ m g sin θ on a pipe that rolls down.
    """

    order = 9

    def reason(self, candidate: Candidate) -> str:
        """See how the answer goes with each number, and whether that is all there is to it."""
        if candidate.easy or candidate.kind.measured(candidate.question.query).whole:
            return ""
        line = product_of(candidate) or sum_of(candidate)
        return "" if line and turns_by_weight(candidate) else line

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """The product or sum, if it is one."""
        yield (
            product_of(candidate) or sum_of(candidate) or "the answer is no product of stated numbers, nor a sum of two"
        )
        if turns_by_weight(candidate):
            yield TURNS


FILTERS.add("one line", OneLine())
