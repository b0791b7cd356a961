"""Drops a question whose solution needs other mathematics than was asked for."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.questions.need import EVERY


class Needs(Filter):
    """The shortest worked solution needs what is not allowed, such as a numerical root.

    By default few questions may need more than elementary means, see `datasets.needs`.
    """

    order = 5

    def ready(self, candidate: Candidate) -> bool:
        """Return whether the shortest solution is cached; if so, this filter is cheap enough to run first."""
        return candidate.is_solved

    def reason(self, candidate: Candidate) -> str:
        """Look at the solution, unless anything is allowed."""
        if candidate.needs == EVERY or candidate.solution is None:
            return ""
        need = candidate.solution.needs
        return "" if need in candidate.needs else f"{need.label}: it needs that"

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """What it needs."""
        if candidate.solution is not None:
            strategy = candidate.solution.strategy
            yield f"{candidate.solution.needs.label}, by {strategy or 'nothing but integration'}"


FILTERS.add("needs", Needs())
