"""Drops a question whose answer only one engine vouches for."""

from collections.abc import Iterator

from sim2reason.generation.filters import FILTERS, Candidate, Filter
from sim2reason.questions import KINDS


class Agreement(Filter):
    """The two engines part, on what is asked or on what happens before it."""

    needs_witness = True
    order = 0

    def reason(self, candidate: Candidate) -> str:
        """Return what the kind of question doubts."""
        query = candidate.question.query
        return KINDS[query.kind].doubt(query, candidate.study, candidate.certificate)

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield how far the engines part on the motion, and until when they were compared."""
        held = candidate.certificate
        if held is not None and held.agreement:
            worst = max(held.agreement, key=lambda channel: held.agreement[channel])
            yield (
                f"the worst difference of the engines is {held.agreement[worst]:.2g} of the largest value, on the "
                f"{worst.quantity} of {worst.subject}; up to {held.tolerance:g} is allowed"
            )
            yield f"they agree until {held.stable_until:.4g} s; events that both saw: {len(held.matched)}"


FILTERS.add("agreement", Agreement())
