"""Drops a problem that is longer than a reader would take."""

from collections.abc import Iterable, Iterator

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
        return "" if followed(candidate.sentences) else f"more than {LONGEST_STRING} words about one string"

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """The count."""
        yield f"{len(candidate.prompt.split())} words of at most {LONGEST}"


def followed(sentences: Iterable[str]) -> bool:
    """Whether no sentence about a string is so long that no finger can follow it."""
    return all(len(sentence.split()) <= LONGEST_STRING for sentence in sentences if "string" in sentence)


FILTERS.add("length", Length())
