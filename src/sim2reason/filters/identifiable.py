"""Drops a question whose result does not fix the number that it asks for."""

import re
from collections.abc import Iterator

from sim2reason.dsl.measures import join_unit
from sim2reason.filters import FILTERS, Candidate, Filter
from sim2reason.modes.reverse import unfixed
from sim2reason.questions.unknown import far_from, range_of
from sim2reason.questions.words import Words


class Identifiable(Filter):
    """Another value of the unknown gives the same result, or the text does not speak of it as of an unknown."""

    order = 10

    def reason(self, candidate: Candidate) -> str:
        """Solve the scene with other values within ten times the range from which the number is drawn."""
        question, words = candidate.question, candidate.words
        if not question.unknown or words is None:
            return ""
        text = " ".join(candidate.sentences)
        if not all(_speaks_of(path, words, text) for path in question.left_open):
            return "the text has no words for the unknown"
        return candidate.study.once(("unfixed", question), lambda: unfixed(question, candidate.study, words))

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """The number, and the range of the others that were tried."""
        question = candidate.question
        if question.unknown and question.given is not None and not self.reason(candidate):
            values = range_of(candidate.study.scene, question.unknown, question.answer)
            values = [*values, *far_from(values, question.answer, question.unit)]
            low, high = (join_unit(f"{value:.3g}", question.unit) for value in (min(values), max(values)))
            yield f"from {low} to {high} no value of {question.unknown} but {question.answer:.4g} gives the result"


def _speaks_of(path: str, words: Words, text: str) -> bool:
    """Whether a text has the symbol of a number, alone or one of many, and not only as its own value: *R = $R$*."""
    alone = next(found.symbol for found in words.unknowns if found.path == path).strip("$")
    for symbol in (alone, words.symbols.get(path, alone)):
        own = rf"(?<!\w){re.escape(_plain(symbol))} = \${re.escape(symbol)}\$"
        if f"${symbol}$" in text and re.search(own, text) is None:
            return True
    return False


def _plain(symbol: str) -> str:
    """A symbol as prose has it in a formula of its own."""
    return {r"\omega": "ω"}.get(symbol, symbol)


FILTERS.add("identifiable", Identifiable())
