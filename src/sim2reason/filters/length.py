"""Drops a problem that is longer than a reader would take."""

from sim2reason.filters import FILTERS, Candidate

LONGEST = 270  # words
LONGEST_STRING = 40  # words in a sentence about a string: more, and no finger can follow it


class Length:
    """The prompt has too many words."""

    needs_witness = False
    order = 2

    def reason(self, candidate: Candidate) -> str:
        """Count words as a word processor does."""
        words = len(candidate.prompt.split())
        if words > LONGEST:
            return f"{words} words"
        strings = max((len(s.split()) for s in candidate.sentences if "string" in s), default=0)
        return f"{strings} words about one string" if strings > LONGEST_STRING else ""


FILTERS.add("length", Length())
