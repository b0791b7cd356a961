"""A question's sentence read back: every ask that its words could mean."""

import re
from collections.abc import Iterator

from sim2reason.questions import KINDS, Moment, Query, Target, Words
from sim2reason.questions.moments import AtStart, AtTime, Collided, Moved, Stopped, pair
from sim2reason.questions.phrasing import FAR, FAST
from sim2reason.questions.targets import targets
from sim2reason.simulation.trace import Trace

_SECONDS = re.compile(r"(\d{1,6}(?:\.\d{1,6})?) s\b")
_METRES = re.compile(r"(\d{1,6}(?:\.\d{1,6})?) m\b")


def parse_question(text: str, trace: Trace, words: Words) -> Query | None:
    """The question that a sentence asks about a motion, found by trying every phrase of every kind; None if no one.

    Times and distances are read from the sentence; the rest must be word for word what `shapes` gives.
    """
    for ask, noun in candidates(text, trace, words):
        for shape in KINDS[ask.kind].shapes(ask, words, noun):
            if shape[0].upper() + shape[1:] == text:
                return ask
    return None


def candidates(text: str, trace: Trace, words: Words) -> Iterator[tuple[Query, str]]:
    """Asks, with their noun phrases, whose numbers and names all stand in a sentence."""
    offered = targets(trace.mechanism, words.mentions)
    nouns: dict[str, Target] = {phrase: target for phrase, target in offered.items() if _heard(phrase, text)}
    for moment in _moments(text, trace, words):
        yield Query("time_to_event", None, moment), ""
        kind = "state" if isinstance(moment, AtTime) else "start" if isinstance(moment, AtStart) else "event"
        for noun, target in nouns.items():
            yield Query(kind, target, moment), noun


def _heard(phrase: str, text: str) -> bool:
    """Whether a noun phrase stands in a sentence, or what a question word makes of it."""
    core = phrase.removeprefix(FAST).removeprefix(FAR).partition(" from its")[0].partition(" relative to")[0]
    return phrase in text or (core != phrase and core.lower() in text.lower())


def _moments(text: str, trace: Trace, words: Words) -> Iterator[Moment]:
    yield AtStart()
    yield from (AtTime(float(number)) for number in _SECONDS.findall(text))
    named = [name for name in trace.mechanism.body if words.mentions.get(name, "\0") in text]
    for name in named:
        yield Stopped(name)
        yield from (Moved(name, float(number)) for number in _METRES.findall(text))
    for met in trace.mechanism.meetings:
        if {met.a, met.b} <= set(words.mentions) and pair(words.mentions[met.a], words.mentions[met.b]) in text:
            yield Collided(met.a, met.b, after=True)
            yield Collided(met.a, met.b, after=False)
