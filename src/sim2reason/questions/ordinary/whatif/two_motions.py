"""Questions about what follows when a string is cut, a hand lets go or a field is switched off during the motion."""

import re
from collections.abc import Iterator
from dataclasses import replace
from math import isclose
from typing import NamedTuple

from sim2reason.errors import SceneError, SimulationError, TextError, UnsupportedError
from sim2reason.questions.following import FollowedMotion, motion_of
from sim2reason.questions.ordinary.hearing import Heard
from sim2reason.questions.ordinary.meaning import Reader, Understood
from sim2reason.questions.ordinary.whatif.removed_things import moment_of, named_things, time_of
from sim2reason.questions.posing import VALUE
from sim2reason.questions.variation import SceneChange, words_in
from sim2reason.questions.words import Words

SAME = 1e-6  # relative: answers that differ by less are one
SHARES = 0.31, 0.47, 0.83  # of the horizon, at which something is removed if the sentence does not say when
_IF = r"(?:(?:suppose|if|imagine|assume|when|after|once|as soon as|supposing|assuming)(?: that)? )?"
_LINE = r"(?:string|rope|cord|thread|rod|spring)"
_FIELD = r"(?:electric|magnetic) field"
_BE = r"(?:is|was|were|be|gets|has been|had been|has|had)"
_GONE = (
    rf"(?P<what>(?:@\d+@ 's )?{_LINE}|@\d+@|{_FIELD}) (?:now |suddenly )*"
    rf"(?:{_BE} (?:now |suddenly |then )*(?:cut(?: through)?|severed|removed|taken away|switched off|turned off|broken"
    r"|burnt through|detached|released)|breaks|broke|snaps|snapped|tears|tore|gives way|gave way|broken)"
    rf"|(?P<hand>hand) (?:suddenly )?(?:lets go|let go|releases|released)(?: of)?(?: (?:@\d+@|it|{_LINE}|its end))?"
    r"|(?P<rests>hand) (?:suddenly )?(?:stops|stopped|ceases|ceased) (?:pulling|to pull)(?: on (?:@\d+@|it|string))?"
)
_BEGUN = (
    r"(?:release|start|beginning|(?:@\d+@|it|they|system|everything) (?:is|are|was|were|has been|starts?|started)"
    r" ?(?:released|let go|set free|let loose)?)"
)
_WHEN = (
    rf"(?: (?P<n>#\d+#) (?:after {_BEGUN}|later)| (?:after|at t =|at time) (?P<m>#\d+#)(?: of motion)?"
    r"| (?P<while>(?:while|as|during) (?:@\d+@|it|they|blocks|its|motion)(?: ?(?:is|are|was|were) (?:still )?"
    r"(?:moving|in motion)| motion)?|at some (?:moment|time|instant|point))"
    r"| (?:just )?(?:when|as|once|after|as soon as|(?:at|from) (?:very )?(?:moment|instant) (?:when|at which|that))"
    r" (?P<clause>[^.]+?))"
)
_AT = rf"(?:(?:after|at t =|at time) (?P<before>#\d+#) ?,? |(?P<early>#\d+#) after {_BEGUN} ?,? )?"
_FIRST = re.compile(rf"^{_IF}{_AT}(?:{_GONE})(?P<told>{_WHEN})?(?:\.| ,) (?P<question>.+)")
_LAST = re.compile(rf"^(?P<question>.+?)(?: ,)? (?:if|after|when|once) (?:{_GONE})(?P<told>{_WHEN})?$")
_IDLE = r"(?P<rests>hand) (?:did|does) not pull(?: (?:at all|on @\d+@|on it|on string))*"
_NOT = re.compile(
    rf"^if {_IDLE} , (?P<question>.+)|^(?P<asked>.+?)(?: ,)? if {_IDLE.replace('<rests>', '<rested>')}$"
    r"|^without (?:pull of )?(?P<no>hand) , (?P<left>.+)"
)
_THEN = re.compile(
    r"(?: ,)? ?\b(?:then|still|afterwards|thereafter|from (?:then|there) on|from (?:that|this) (?:moment|instant|time)"
    r"(?: on)?|after (?:that|this)|after (?:@\d+@|string|hand|it) (?:breaks|snaps|is cut|lets go|has (?:broken|snapped"
    r"|been cut|let go)|broke|snapped)|after (?:break|cut|cutting))\b(?: ,)?"
)
_FARTHER = {
    r"^how much (?:farther|further)\b": "how far",
    r"^how (?:much|many metres) higher (?=(?:does|will|would|do) @\d+@ )": "how far up ",
    r"^how (?:much|many seconds) longer\b": "how long",
    r"^how long (?P<do>does|will|would|do) (?P<s>@\d+@) (?:go on|keep|keep on|continue) (?:sliding|moving|rising"
    r"|to slide|to move|to rise)(?: up(?:wards)?)?(?: \w+)?$": r"how long \g<do> \g<s> take to come to rest",
    r"\b(?:further|additional|extra) (?=distance|time|height)": "",
}
_OF_OLD = re.compile(
    r"\b(?:start|starting|initial|initially|release|released|beginning|altogether|total|first|second|original|t =)\b"
)
_LATER = re.compile(r" (#\d+#) after start$")  # as a number of seconds *later* is heard
_FIXED = re.compile(r"^(?:with what|what is|what would|at what|how fast|find|determine|calculate) ")
_UP = re.compile(r"^how far up (?P<do>does|will|would|do) (?P<s>@\d+@) (?:get|go|rise|climb|move|slide|come)s?\b")


class RemovedThings(NamedTuple):
    """The removal that a sentence supposes: names of lines and fields, times to try, s, and the question that remains.

    If the sentence does not say when, there are several times, for which the answers must agree.
    """

    names: tuple[str, ...]
    times: tuple[float, ...]
    question: str


def after_removal_of_things(heard: Heard, motion: FollowedMotion, words: Words, reader: Reader) -> Understood | None:
    """Return the meaning of a sentence such as *the string is cut after 2 s; how much farther does A slide*.

    None if the sentence is not understood so.
    """
    for removed in _removed(heard, motion, words, reader):
        told = replace(heard, text=removed.question)
        first = _after(removed.names, removed.times[0], told, motion, words, reader)
        if first is None or (first.followed.answer is None and len(removed.times) > 1):
            continue
        others = (_after(removed.names, time, told, motion, words, reader) for time in removed.times[1:])
        if all(each is not None and _agree(each.followed.answer, first.followed.answer) for each in others):
            return first
    return None


def _agree(one: float | None, other: float | None) -> bool:
    return one is not None and other is not None and isclose(one, other, rel_tol=SAME)


def _after(
    names: tuple[str, ...], time: float, heard: Heard, motion: FollowedMotion, words: Words, reader: Reader
) -> Understood | None:
    """Return the meaning of a question about what follows when things are removed at a time, s."""
    varied = SceneChange(removed=names, after=time)
    try:
        scene = varied.applied(motion.study.scene)
        there = motion_of(scene)
    except (SceneError, SimulationError, UnsupportedError, ValueError) as error:
        raise TextError("question", f"nothing follows: {error}", "let it happen at another moment") from None
    found = reader.read(heard, there, words_in(scene, words))
    if found is None or found.posed.unknown is not None:
        return None
    structured = replace(found.asked, change=varied.told, compare=VALUE)
    return Understood(structured, replace(found.posed, varied=varied), found.followed)


def _removed(heard: Heard, motion: FollowedMotion, words: Words, reader: Reader) -> Iterator[RemovedThings]:
    """Yield each way to read a sentence as one about what follows a removal."""
    for told in (_FIRST, _LAST, _NOT):
        found = told.match(heard.text)
        if found is None:
            continue
        groups = found.groupdict()
        what = next((said for name in ("what", "hand", "rests", "rested", "no") if (said := groups.get(name))), "")
        names = named_things(what, heard, words)
        if not names:
            continue
        if told is _NOT:
            yield RemovedThings(names, (0.0,), _plainly(groups["question"] or groups["asked"] or groups["left"]))
            continue
        question = _of_what_follows(groups["question"])
        times = _times(groups, heard, motion, words, reader) if question else ()
        if (later := _LATER.search(question)) and not _is_later(later[1], times, heard, words):
            question = ""
        if question and times:
            yield RemovedThings(names, times, question)


def _times(
    groups: dict[str, str | None], heard: Heard, motion: FollowedMotion, words: Words, reader: Reader
) -> tuple[float, ...]:
    """Return the time that a sentence states, s, or some times if it states none; no time if it is not understood."""
    stated = groups.get("n") or groups.get("m") or groups.get("before") or groups.get("early") or ""
    clause = groups.get("clause") or ""
    if sum(map(bool, (stated, clause, groups.get("while")))) > 1:
        return ()
    if stated or clause:
        time = time_of(stated, heard, words) if stated else moment_of(clause, heard, motion, words, reader)
        return (time,) if time is not None else ()
    return tuple(share * motion.study.scene.horizon for share in SHARES)


def _is_later(token: str, times: tuple[float, ...], heard: Heard, words: Words) -> bool:
    """Return whether a time *after start* can only be meant as later than what is removed, since it is the shorter."""
    time = time_of(token, heard, words)
    return time is not None and all(time < removal for removal in times)


def _of_what_follows(question: str) -> str:
    """Return a question such as *how much farther does A then slide* without what says that it is about what follows.

    It is empty if the question may be about the motion from the start on: a distance or a time without such a word.
    """
    plain = _THEN.sub(" ", question)
    for told, said in _FARTHER.items():
        plain = re.sub(told, said, plain)
    plain = " ".join(plain.split())
    numbers = re.findall(r"#\d+#", _LATER.sub("", question))
    follows = plain != question or (_FIXED.match(question) is not None and not numbers)
    if not follows or _OF_OLD.search(_LATER.sub("", plain)):
        return ""
    return _plainly(_UP.sub(r"how far \g<do> \g<s> rise", plain))


def _plainly(question: str) -> str:
    """Return a question in the indicative."""
    said = re.sub(r"^(?P<a>what|which|how large|how great) would (?P<x>.+?) be$", r"what is \g<x>", question)
    said = re.sub(r"^what would be (?=period|radius|speed|acceleration|frequency)", "what is ", said)
    said = re.sub(r"(?<=@) 's circular motion$", "", said)
    said = re.sub(r"\b(?:would|will)\b", "does", said)
    return " ".join(re.sub(r"\bit\b(?= (?:stop|come|turn))", "it", said).split()).strip(" ,")


def goes_on_otherwise(text: str) -> bool:
    """Return whether a sentence supposes that something is removed in the course of the motion."""
    return _FIRST.match(text) is not None
