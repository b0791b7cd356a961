"""Drops a formula that too few of the symbols stand in, as d/2 for the way of one of two bodies."""

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.filters.parts.reach import least


class FewSymbols(Filter):
    """The formula holds fewer numbers of bodies and of the question than must move an answer in numbers.

    The numbers of the world, as g, do not count there either.
    """

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """Count them, whatever their powers."""
        formula = candidate.question.formula
        if formula is None:
            return ""
        wanted = least(candidate)
        return f"{len(formula.within)} symbols of {wanted}" if len(formula.within) < wanted else ""


FILTERS.add("few symbols", FewSymbols())
