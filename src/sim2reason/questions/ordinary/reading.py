"""The readings of a question in ordinary English: all questions in parts that it may be."""

import re
from collections.abc import Iterator
from dataclasses import dataclass

from sim2reason.questions.ordinary.hearing import Heard, hear
from sim2reason.questions.ordinary.mains import mains
from sim2reason.questions.ordinary.readers import FREE, MOMENT, STRETCH, Main
from sim2reason.questions.ordinary.vocabulary import pattern
from sim2reason.questions.ordinary.whens import AFTER, DURING, THEN, When, split, ways_of, whens
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.words import Words

_AT_EVENT = r"((?:with |at )?what [a-z ]+?) (?:does |is |has |do |will )(@\d+@) (.+)"
_TAKES = r"how long (?:does |will |would )?(@\d+@) (?:take|need|require)s?(?: to)? (.+)"
_LASTS = r"how long (?:does |do |will )?(@\d+@) (?:[a-z]+ (?:on @\d+@ )?)(before|until) (.+)"
_GOES_ON = pattern("[{s} ]~(?:{motion=MOTION}|SLIPS|motion)[ {way=WAY}| ALONG_IT| on {t}| on it]")


@dataclass(frozen=True, slots=True)
class Reading:
    """A question in parts; on which side of its moment it asks; and what it takes for granted.

    That is which ways bodies have `gone` till then, and are `moving` then. One that is `steady` names no moment: it
    asks for what does not change.
    """

    asked: StructuredQuestion
    side: str = THEN
    gone: tuple[tuple[str, str], ...] = ()
    moving: tuple[tuple[str, str], ...] = ()
    steady: bool = False


def readings(sentence: str, words: Words) -> tuple[Reading, ...]:
    """All that a sentence may ask; empty if it is not understood."""
    heard = hear(sentence, words)
    found = (reading for parts in _parts(heard.text) for reading in _of_parts(*parts, heard))
    return tuple(dict.fromkeys(found))


def _parts(text: str) -> Iterator[tuple[str, str, str]]:
    """The main clause, the clause beside it and its side, however they are put."""
    text = re.sub(r" (?:,)$", "", text)
    yield from split(text)
    at_event = re.fullmatch(_AT_EVENT, text)
    if at_event is not None:
        yield f"{at_event[1]} {at_event[2]}", f"{at_event[2]} {at_event[3]}", THEN
    takes = re.fullmatch(_TAKES, text)
    if takes is not None:
        yield "when", f"{takes[1]} {takes[2]}", THEN
    lasts = re.fullmatch(_LASTS, text)
    if lasts is not None:
        yield "when", lasts[3], THEN
    time = pattern("TIME[ for] (?P<clause>.+)").fullmatch(text)
    if time is not None:
        yield "when", re.sub(pattern("~").pattern, "", time["clause"], count=1), THEN


def _of_parts(question: str, clause: str, side: str, heard: Heard) -> Iterator[Reading]:
    for main in mains(question, heard):
        if not clause:
            yield from _alone(main)
        elif main.needs != FREE and main.when is None:
            for when in whens(clause, heard, main.of or heard.subject("@0@" if heard.subjects else None), side):
                yield _with(main, when)
        going = _GOES_ON.fullmatch(clause) if clause and side in (DURING, THEN) and main.needs == MOMENT else None
        if going is not None:
            ways = ways_of(going, heard.subject(going["s"]) or main.of)
            yield Reading(_asked(main, ""), DURING, moving=(*main.ways, *ways), steady=True)


def _alone(main: Main) -> Iterator[Reading]:
    if main.when is not None:
        yield _with(main, main.when)
    elif main.find != "time":
        yield Reading(_asked(main, ""), moving=main.ways, steady=main.needs == MOMENT)


def _with(main: Main, when: When) -> Reading:
    side = AFTER if main.needs == STRETCH else when.side
    told = when.told.removesuffix(" before") if main.find == "time" else when.told
    gone, moving = (main.ways, ()) if main.needs == STRETCH else ((), main.ways)
    return Reading(_asked(main, told), side, (*gone, *when.ways), moving)


def _asked(main: Main, when: str) -> StructuredQuestion:
    return StructuredQuestion(main.find, main.of, when, main.along)
