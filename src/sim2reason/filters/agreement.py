"""Drops a question whose answer only one engine vouches for."""

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.questions import KINDS


class Agreement(Filter):
    """The two engines part, on what is asked or on what happens before it."""

    needs_witness = True
    order = 0

    def reason(self, candidate: Candidate) -> str:
        """What the kind of question doubts."""
        query = candidate.question.query
        return KINDS[query.kind].doubt(query, candidate.study, candidate.certificate)


FILTERS.add("agreement", Agreement())
