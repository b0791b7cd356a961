"""Drops a problem that is longer than a reader would take."""

from collections.abc import Iterator

from sim2reason.filters import FILTERS, Candidate, Filter

LONGEST = 270  # words
LONGEST_STRING = 40  # words in a sentence about a string: more, and no finger can follow it


class Length(Filter):
    """The prompt has too many words."""

    order = 2

    def reason(self, candidate: Candidate) -> str:
        """Count words as a word processor does."""
        words = len(candidate.prompt.split())
        if words > LONGEST:
            return f"{words} words"
        strings = max((len(s.split()) for s in candidate.sentences if "string" in s), default=0)
        return f"{strings} words about one string" if strings > LONGEST_STRING else ""

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """The count."""
        yield f"{len(candidate.prompt.split())} words of at most {LONGEST}"


FILTERS.add("length", Length())
