"""Drops a formula that has too few of the given symbols, as d/2 for the way of one of two bodies, or lacks too many."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.filters.parts.reach import EVER, least


class FewSymbols(Filter):
    """The formula holds fewer numbers of bodies and of the question than must move an answer in numbers.

    The numbers of the world, as g, do not count there either. Or it lacks more of the symbols than of an answer in
    numbers may be idle: where a spring passes its natural length, nothing hangs on its stiffness.
    """

    order = 1

    def reason(self, candidate: Candidate) -> str:
        """Count them, whatever their powers."""
        formula = candidate.question.formula
        if formula is None:
            return ""
        wanted, told = least(candidate), len(formula.symbols)
        if len(formula.within) < wanted:
            return f"{len(formula.within)} symbols of {wanted}"
        return f"idle symbols: {len(formula.without)} of {told}" if len(formula.without) > EVER * told else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """How many symbols the formula holds and lacks."""
        formula = candidate.question.formula
        if formula is not None:
            yield f"{len(formula.within)} symbols of bodies and of the question; {least(candidate)} must be there"
            yield f"{len(formula.without)} of all {len(formula.symbols)} symbols are missing; up to {EVER:.0%} may be"


FILTERS.add("few symbols", FewSymbols())
