"""Drops a problem that is longer than a reader would take."""

from sim2reason.filters import FILTERS, Candidate

LONGEST = 270  # words


class Length:
    """The prompt has too many words."""

    needs_witness = False
    order = 2

    def reason(self, candidate: Candidate) -> str:
        """Count words as a word processor does."""
        words = len(candidate.prompt.split())
        return f"{words} words" if words > LONGEST else ""


FILTERS.add("length", Length())
