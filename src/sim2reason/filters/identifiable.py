"""Drops a question whose result does not fix the number that it asks for."""

import re

from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.modes.reverse import unfixed


class Identifiable(Filter):
    """Another value of the unknown gives the same result, or the text does not speak of it as of an unknown."""

    order = 10

    def reason(self, candidate: Candidate) -> str:
        """Solve the scene with other values within ten times the range from which the number is drawn."""
        question, words = candidate.question, candidate.words
        if not question.unknown or words is None:
            return ""
        symbol = next(found.symbol for found in words.unknowns if found.path == question.unknown).strip("$")
        text = " ".join(candidate.sentences)
        if f"${symbol}$" not in text or re.search(
            rf"(?<!\w){re.escape(_plain(symbol))} = \${re.escape(symbol)}\$", text
        ):
            return "the text has no words for the unknown"
        return unfixed(question, candidate.study)


def _plain(symbol: str) -> str:
    """A symbol as prose has it in a formula of its own."""
    return {r"\omega": "ω"}.get(symbol, symbol)


FILTERS.add("identifiable", Identifiable())
