"""References to the moment of the preceding question as *that moment*, and their resolution."""

from collections.abc import Iterator

from sim2reason.questions.moments import Happening, Moment
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.words import Words

THAT = "that moment"


def with_reference(text: str, moment: Moment | None, words: Words) -> str:
    """Return a question with *that moment* for the preceding question's moment; unchanged if that is not shorter."""
    for told, short in _phrases(moment, words):
        if told in text:
            return text.replace(told, short, 1)
        if text.startswith(sentence(told)):
            return sentence(short) + text.removeprefix(sentence(told))
    return text


def resolved_references(text: str, moment: Moment | None, words: Words) -> Iterator[str]:
    """Yield all possible meanings of a question with *that moment*, given the moment of the preceding one."""
    for told, short in _phrases(moment, words):
        if text.startswith(sentence(short)):
            yield sentence(told) + text.removeprefix(sentence(short))
        if short in text:
            yield text.replace(short, told, 1)


def _phrases(moment: Moment | None, words: Words) -> list[tuple[str, str]]:
    """Return the full and the short phrases for a moment, longest first; none for other moments.

    Those just before or after an event must say so.
    """
    if not isinstance(moment, Happening | AtTime) or moment.sided is not None:
        return []
    clause = moment.clause(words) if isinstance(moment, Happening) else None
    told = [(phrase, f"at {THAT}") for phrase in moment.phrases(words)]
    if isinstance(moment, AtTime):
        told += [(stretch, f"until {THAT}") for stretch in moment.stretches(words)]
    if clause is not None:
        told += [(f"until {clause.statement}", f"until {THAT}"), (f"the moment when {clause.statement}", THAT)]
    subject = moment.subject(words)
    if subject:
        told += [(phrase.replace(subject, moment.pronoun, 1), short) for phrase, short in told if subject in phrase]
    return sorted(told, key=lambda pair: -len(pair[0]))
