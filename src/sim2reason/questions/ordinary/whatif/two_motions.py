"""Questions about the motion after a string is cut, a hand lets go or a field is switched off."""

import re
from collections.abc import Iterator
from dataclasses import replace
from math import isclose
from typing import NamedTuple

from sim2reason.errors import SceneError, SimulationError, TextError, UnsupportedError
from sim2reason.questions.following import FollowedMotion, simulate_scene
from sim2reason.questions.ordinary.hearing import ALL_WORD, TokenizedSentence
from sim2reason.questions.ordinary.reading import Reader, UnderstoodQuestion
from sim2reason.questions.posing import VALUE, pose_question
from sim2reason.questions.structured import StructuredQuestion, parse_amount
from sim2reason.questions.variation import FIELDS, SceneChange, find_removable, words_in
from sim2reason.questions.words import Words
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.subjects.bodies import Bodies

_STRINGS = frozenset({"string", "rope", "cord", "thread"})
_MOVES = re.compile(
    r"(?P<s>@\d+@) (?:is|are|was|were|has been) (?:just )?(?P<verb>moving|sliding|rising|falling|going up|going down"
    r"|climbing|sinking)(?P<way> up(?:wards)?(?: \w+)?| down(?:wards)?(?: \w+)?)? (?:at|with)"
    r"(?: speed of)? (?P<n>#\d+#)"
)
_REACHES = re.compile(r"(?P<s>@\d+@) (?:reaches|has reached|attains|has) (?:speed of )?(?P<n>#\d+#)")
_UP_REMOVED = re.compile(r"rising|up|climbing")
_DOWN = re.compile(r"falling|down|sinking")


def named_things(text: str, sentence: TokenizedSentence, words: Words) -> tuple[str, ...]:
    """Return the names of the lines or the field that a phrase denotes; none if it is ambiguous.

    *string* alone means the only string, and *@0@ 's string* the only one that ends at a body.
    """
    things = find_removable(words)
    lines = words.mechanism.lines
    owner = re.match(r"(@\d+@) 's ", text)
    if owner is not None:
        body = _body(sentence.subject(owner[1]), words)
        sites = {site.name for site in words.mechanism.site.values() if site.body == body}
        names = {line.whole for line in lines if sites & {line.through[0], line.through[-1]}}
    elif text.startswith("@"):
        names = {name for name, phrase in things.items() if phrase == sentence.subject(text)}
    elif text in _STRINGS:
        names = {line.whole for line in lines}
    elif text == "hand":
        names = {line.whole for line in words.mechanism.pulls}
    else:
        names = {name for name, phrase in things.items() if phrase in FIELDS.values() and phrase == f"the {text}"}
    return tuple(names) if len(names) == 1 and names <= {*things, *(line.whole for line in lines)} else ()


def _body(phrase: str, words: Words) -> str:
    return next((name for name, mention in words.subject_phrases(Bodies()).items() if mention == phrase), "")


def time_of(stated: str, sentence: TokenizedSentence, words: Words) -> float | None:
    """Return the time, in the scene's unit, of a number token; None if it is not a time."""
    try:
        return parse_amount("question", sentence.number(stated), words.units.spell("s"))
    except TextError:
        return None


def moment_of(
    clause: str, sentence: TokenizedSentence, motion: FollowedMotion, words: Words, reader: Reader
) -> float | None:
    """Return the time of the moment that a clause such as *A has slid 2 m* names; None if it is not understood."""
    moving = _MOVES.fullmatch(clause) or _REACHES.fullmatch(clause)
    if moving is not None:
        return _time_of_speed(moving, sentence, motion, words)
    meaning = reader.read(replace(sentence, text=f"how long is it until {clause}"), motion, words)
    return meaning.simulated_answer.answer if meaning is not None and meaning.asked.find == "time" else None


def _time_of_speed(
    moving: re.Match[str], sentence: TokenizedSentence, motion: FollowedMotion, words: Words
) -> float | None:
    """Return the first time, s, at which a body has a stated speed; None if it then moves the other way."""
    phrase = sentence.subject(moving["s"]).removeprefix(f"{ALL_WORD} ").partition(" & ")[0]
    body = _body(phrase, words)
    direction_words = f"{moving.groupdict().get('verb') or ''} {moving.groupdict().get('way') or ''}"
    try:
        structured = StructuredQuestion("time", when=f"speed of {body} = {sentence.number(moving['n'])}")
        followed = pose_question(structured, motion, words).simulate_answer(motion)
    except TextError:
        return None
    if followed.answer is None:
        return None
    rising = float(Velocity.evaluate(followed.study.trace.at(followed.answer), body)[0, 2])
    wrong = (_UP_REMOVED.search(direction_words) and rising <= 0.0) or (_DOWN.search(direction_words) and rising >= 0.0)
    return None if wrong else followed.answer


ANSWER_RTOL = 1e-6  # relative: answers that differ by less are equal
REMOVAL_TIME_FRACTIONS = 0.31, 0.47, 0.83  # of the horizon: times of removal if the sentence states none
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
_HOW_FAR_UP = re.compile(
    r"^how far up (?P<do>does|will|would|do) (?P<s>@\d+@) (?:get|go|rise|climb|move|slide|come)s?\b"
)


class RemovedThings(NamedTuple):
    """A supposed removal: names of lines and fields, times to try, s, and the remaining question.

    If the sentence does not say when, there are several times, for which the answers must agree.
    """

    names: tuple[str, ...]
    times: tuple[float, ...]
    question: str


def after_removal_of_things(
    sentence: TokenizedSentence, motion: FollowedMotion, words: Words, reader: Reader
) -> UnderstoodQuestion | None:
    """Return the meaning of a sentence such as *the string is cut after 2 s; how much farther does A slide*.

    None if the sentence is not understood so.
    """
    for removed in _removed(sentence, motion, words, reader):
        question_sentence = replace(sentence, text=removed.question)
        first = _after(removed.names, removed.times[0], question_sentence, motion, words, reader)
        if first is None or (first.simulated_answer.answer is None and len(removed.times) > 1):
            continue
        others = (_after(removed.names, time, question_sentence, motion, words, reader) for time in removed.times[1:])
        if all(
            each is not None and _agree(each.simulated_answer.answer, first.simulated_answer.answer) for each in others
        ):
            return first
    return None


def _agree(one: float | None, other: float | None) -> bool:
    return one is not None and other is not None and isclose(one, other, rel_tol=ANSWER_RTOL)


def _after(
    names: tuple[str, ...],
    time: float,
    sentence: TokenizedSentence,
    motion: FollowedMotion,
    words: Words,
    reader: Reader,
) -> UnderstoodQuestion | None:
    """Return the meaning of a question about the motion after objects are removed at a time, s."""
    varied = SceneChange(removed=names, after=time)
    try:
        scene = varied.applied(motion.study.scene)
        there = simulate_scene(scene)
    except (SceneError, SimulationError, UnsupportedError, ValueError) as error:
        raise TextError("question", f"nothing follows: {error}", "let it happen at another moment") from None
    meaning = reader.read(sentence, there, words_in(scene, words))
    if meaning is None or meaning.posed_question.unknown is not None:
        return None
    structured = replace(meaning.asked, change=varied.text, compare=VALUE)
    return UnderstoodQuestion(structured, replace(meaning.posed_question, varied=varied), meaning.simulated_answer)


def _removed(
    sentence: TokenizedSentence, motion: FollowedMotion, words: Words, reader: Reader
) -> Iterator[RemovedThings]:
    """Yield each reading of a sentence as a question about the motion after a removal."""
    for regex in (_FIRST, _LAST, _NOT):
        match = regex.match(sentence.text)
        if match is None:
            continue
        groups = match.groupdict()
        what = next((phrase for name in ("what", "hand", "rests", "rested", "no") if (phrase := groups.get(name))), "")
        names = named_things(what, sentence, words)
        if not names:
            continue
        if regex is _NOT:
            yield RemovedThings(names, (0.0,), _plainly(groups["question"] or groups["asked"] or groups["left"]))
            continue
        question = _of_what_follows(groups["question"])
        times = _times(groups, sentence, motion, words, reader) if question else ()
        if (later := _LATER.search(question)) and not _is_later(later[1], times, sentence, words):
            question = ""
        if question and times:
            yield RemovedThings(names, times, question)


def _times(
    groups: dict[str, str | None], sentence: TokenizedSentence, motion: FollowedMotion, words: Words, reader: Reader
) -> tuple[float, ...]:
    """Return the stated time, s, or several if none is stated; empty if the clause is not understood."""
    stated = groups.get("n") or groups.get("m") or groups.get("before") or groups.get("early") or ""
    clause = groups.get("clause") or ""
    if sum(map(bool, (stated, clause, groups.get("while")))) > 1:
        return ()
    if stated or clause:
        time = time_of(stated, sentence, words) if stated else moment_of(clause, sentence, motion, words, reader)
        return (time,) if time is not None else ()
    return tuple(share * motion.study.scene.horizon for share in REMOVAL_TIME_FRACTIONS)


def _is_later(token: str, times: tuple[float, ...], sentence: TokenizedSentence, words: Words) -> bool:
    """Return whether a stated time is less than that of the removal, so that it must be counted from the removal."""
    time = time_of(token, sentence, words)
    return time is not None and all(time < removal for removal in times)


def _of_what_follows(question: str) -> str:
    """Return a question such as *how much farther does A then slide* without words such as *farther* and *then*.

    It is empty if the question may be about the motion from the start on: a distance or a time without such a word.
    """
    plain = _THEN.sub(" ", question)
    for regex, replacement in _FARTHER.items():
        plain = re.sub(regex, replacement, plain)
    plain = " ".join(plain.split())
    numbers = re.findall(r"#\d+#", _LATER.sub("", question))
    follows = plain != question or (_FIXED.match(question) is not None and not numbers)
    if not follows or _OF_OLD.search(_LATER.sub("", plain)):
        return ""
    return _plainly(_HOW_FAR_UP.sub(r"how far \g<do> \g<s> rise", plain))


def _plainly(question: str) -> str:
    """Return a question in the indicative."""
    indicative = re.sub(r"^(?P<a>what|which|how large|how great) would (?P<x>.+?) be$", r"what is \g<x>", question)
    indicative = re.sub(r"^what would be (?=period|radius|speed|acceleration|frequency)", "what is ", indicative)
    indicative = re.sub(r"(?<=@) 's circular motion$", "", indicative)
    indicative = re.sub(r"\b(?:would|will)\b", "does", indicative)
    return " ".join(re.sub(r"\bit\b(?= (?:stop|come|turn))", "it", indicative).split()).strip(" ,")


def goes_on_otherwise(text: str) -> bool:
    """Return whether a sentence supposes that something is removed in the course of the motion."""
    return _FIRST.match(text) is not None
