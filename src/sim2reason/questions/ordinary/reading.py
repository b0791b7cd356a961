"""Readings of a question in ordinary English, each a structured question."""

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import NamedTuple

from sim2reason.questions.following import FollowedMotion, SimulatedAnswer
from sim2reason.questions.ordinary.base_forms import PLACE_PATTERN, with_base_forms
from sim2reason.questions.ordinary.changes import above_lowest, after_bounce, moments_of_change, read_differences
from sim2reason.questions.ordinary.clauses import read_moments
from sim2reason.questions.ordinary.hearing import ALL_WORD, TokenizedSentence
from sim2reason.questions.ordinary.mains import read_main_clause
from sim2reason.questions.ordinary.moment_phrases import (
    AFTER,
    BEFORE,
    DURING,
    LATE_TIME_PATTERN,
    LONG,
    THEN,
    When,
    read_directions,
    split,
)
from sim2reason.questions.ordinary.readers import CHANGES, CLAUSED, FREE, LANDING, MOMENT, STRETCH, Main
from sim2reason.questions.ordinary.vocabulary import MOTIONS, RESTS, THEN_GOES, pattern
from sim2reason.questions.posing import MINUS, PosedQuestion
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.words import Words

_PLACE = r"(?: away| from (?:[a-z ]+?|@\d+@)| above [a-z ]+?)"
_DOES = "(?:does |is |has |do |will |are |have |did |can )"
_AT_EVENT = (
    rf"((?:with |at |to |in )?(?:what|which) [a-z ]+?|how (?:fast|quickly|steeply|large [a-z ]+?|great [a-z ]+?|(?:far"
    rf"|high){_PLACE}?))"
    rf" {_DOES}(@\d+@|engine|fuel) (.+)"
)
_REBOUNDS = re.compile(r"(?:rebound|bounce|spring back|come off|bounce back|jump up)\b")
_IMPACT = pattern("(?:its |their |@0@ 's )?(?:ORDINAL )?(?:bounce|impact|collision|rebound)")  # in which nothing falls
_VALUES = "with what", "at what", "how fast", "what"
_TAKES = (
    r"how (?:long|much time|many seconds) (?:does |do |will |would )?(@\d+@) (?:take|need|require)s?(?: to| for)? (.+)"
)
_LASTS = r"how long (?:does |do |will )?(@\d+@) (?:[a-z]+ (?:on @\d+@ )?)(before|until) (.+)"
_LASTS_LOOSELY = r"(?:for )?how long (?:is |does |do |will |are |has )?(@\d+@) (.*?)(before|until|till) (.+)"
_GOING = frozenset(" ".join(with_base_forms(" ".join(MOTIONS.values())).split()).split()) | {
    "in",
    "stay",
    "remain",
    "keep",
    "on",
    "under",
    "way",
}
_LATER_ONE = re.compile(r"\b(?:second|third|fourth|fifth|sixth|next|last)\b")
_GOES_ON = pattern(
    "(?:[{s} |system |everything |whole system |they |both ]~(?:{motion=MOTION}|SLIPS|motion|in motion)[ {way=WAY}|"
    " ALONG_IT| on {t}| on it]|[its ]way (?P<on>up|down))"
)
_ON_ITS_WAY = pattern(
    "(?:[its |{s} 's ]way|@0@ ~MOTION) (?P<on>up|down)[ SURFACE]|[its |@0@ 's ](?P<noun>ascent|climb|rise|descent|fall)"
)
_INVERTED = re.compile(r"^(?P<verb>is|has) (?P<who>(?:all )?fuel|engine|@\d+@)(?= )")
_BOTH = re.compile(r"(?:both )?(@\d+@) and (@\d+@)")
_THEN = re.compile(r" (?:then|there|at (?:that|this) (?:moment|instant|time|point))$")
_SUPPOSED = re.compile(r"^(?:suppose|consider|imagine)(?: that)? ")
_BEGINS = pattern(
    "(?:{s}|system|everything) ~(?:released|let go|launched|thrown|set free|struck|started)[ from rest][ at START]"
)
_BEGUN = pattern("START")
_SLIPPING = pattern("(?:[{s} ]~|its )(?:slipping|skidding|slips|skids)")
DEFLECTION = "angle of deflection"  # in a collision: the angle after it
INCLINATION = "angle with the horizontal"  # of a velocity
ROTATION_QUANTITIES = "revolutions made", "angle rolled", "angle turned"
RISES = "ascent", "climb", "rise"
_LANDED = re.compile(r"\b(?:landed|bounced)\b")
_SEVERAL = re.compile(rf"\b{ALL_WORD} \S.*? & \S+(?: [A-Z](?= |$))?(?: & \S+ [A-Z](?= |$))*")


@dataclass(frozen=True, slots=True)
class Reading:
    """A structured question that a sentence may mean, the side of its moment, and its presumptions.

    The presumptions are the ways that bodies have `gone` until the moment and are `present_directions` at the moment.
    A `steady` reading names no moment: it asks for a value that does not change. A reading of a higher `rank` counts
    only where the scene has none of a lower rank. Where a number of the scene decides an outcome, the reading asks for
    the `least` or the greatest number for which the outcome `happens`, or does not.
    """

    asked: StructuredQuestion
    side: str = THEN
    gone: tuple[tuple[str, str], ...] = ()
    present_directions: tuple[tuple[str, str], ...] = ()
    steady: bool = False
    rank: int = 0
    least: bool | None = None
    happens: bool = True


def read_sentence(sentence: TokenizedSentence) -> tuple[Reading, ...]:
    """Return all readings of a sentence; empty if the sentence is not understood."""
    for variant in (sentence, _together(sentence)):
        between = [_with(main, when) for main, when in read_differences(variant)]
        candidates = between or [reading for parts in _parts(variant.text) for reading in _read_parts(*parts, variant)]
        if distinct := tuple(
            dict.fromkeys(each for reading in candidates for each in _split_by_body(reading) if _tells(each))
        ):
            return distinct
    return ()


def _tells(reading: Reading) -> bool:
    """Return False for a question that asks for a time and itself states that time; True for all other questions."""
    return reading.asked.find != "time" or not (reading.asked.when.startswith("at ") or reading.asked.when == LONG)


def _together(sentence: TokenizedSentence) -> TokenizedSentence:
    """Return a sentence with one token for two subjects joined by *and*, so that the question concerns both."""
    match = _BOTH.search(sentence.text)
    if match is None:
        return sentence
    one, other = (sentence.subject(match[number]).removeprefix(f"{ALL_WORD} ") for number in (1, 2))
    both = f"{ALL_WORD} {one} & {other}"
    token = f"@{len(sentence.subjects)}@"
    return replace(sentence, text=_BOTH.sub(token, sentence.text, count=1), subjects=(*sentence.subjects, both))


def _split_by_body(reading: Reading) -> Iterator[Reading]:
    """Yield one reading for each body of the reading's moment if the moment has several, unless they collide."""
    several = _SEVERAL.search(reading.asked.when)
    if several is None or "collided" in reading.asked.when:
        yield reading
        return
    for who in several[0].removeprefix(f"{ALL_WORD} ").split(" & "):
        when = reading.asked.when.replace(several[0], who)
        gone = tuple((who if subject == several[0] else subject, presumption) for subject, presumption in reading.gone)
        yield replace(reading, asked=replace(reading.asked, when=when), gone=gone)


def _parts(text: str) -> Iterator[tuple[str, str, str]]:
    """Yield every split of a sentence into a main clause, a clause that names a moment, and the side of the moment."""
    text = re.sub(r" (?:,)$", "", text)
    stated, parted, question = text.rpartition(". ")
    if parted and _BEGINS.fullmatch(stated):
        yield from _parts(question)
    elif parted and "." not in stated:
        yield _THEN.sub("", question), _SUPPOSED.sub("", stated), THEN
    yield from split(text)
    at_event = re.fullmatch(_AT_EVENT, text)
    if at_event is not None:
        question = f"{at_event[1].removesuffix(' away')} {at_event[2] if '@' in at_event[2] else ''}".strip()
        rebounds = question.startswith(_VALUES) and _REBOUNDS.match(at_event[3]) is not None
        yield question, f"{at_event[2]} {at_event[3]}", AFTER if rebounds else THEN
    takes = re.fullmatch(_TAKES, text)
    if takes is not None:
        yield "when", f"{takes[1]} {takes[2]}", THEN
    lasts = re.fullmatch(_LASTS, text)
    if lasts is not None:
        yield "when", lasts[3], THEN
    goes_on = re.fullmatch(_LASTS_LOOSELY, text)
    if (
        goes_on is not None
        and not set(PLACE_PATTERN.sub(" ", with_base_forms(goes_on[2])).split()) - _GOING
        and not _LATER_ONE.search(goes_on[4])
    ):
        yield "when", goes_on[4], THEN
    time = pattern("TIME[ for] (?P<clause>.+)").fullmatch(text)
    if time is not None:
        yield "when", re.sub(pattern("~").pattern, "", time["clause"], count=1), THEN
        yield "when", _INVERTED.sub(r"\g<who> \g<verb>", time["clause"]), THEN


def _read_parts(question: str, clause: str, side: str, sentence: TokenizedSentence) -> Iterator[Reading]:
    between = (*after_bounce(question, clause, side, sentence), *above_lowest(question, clause, side, sentence))
    yield from (_with(main, when) for main, when in between)
    for main in read_main_clause(question, sentence):
        if not clause or (main.needs == STRETCH and side == AFTER and _BEGUN.fullmatch(clause)):
            yield from _alone(main)
        elif (
            main.needs != FREE and main.when is None and not (main.needs == STRETCH and side == AFTER and _late(clause))
        ):
            for when in read_moments(
                clause, sentence, main.of or sentence.subject("@0@" if sentence.subjects else None), side
            ):
                if _not_meant(main, when, clause, side):
                    continue
                if main.needs in CHANGES:
                    both = moments_of_change(main, when, side)
                    yield from (_with(replace(main, needs=MOMENT), moment) for moment in filter(None, (both,)))
                elif main.needs != LANDING or _LANDED.search(when.told):
                    yield _with(main, when)
        yield from _on_the_way(main, clause, side, sentence)
        going = _GOES_ON.fullmatch(clause) if clause and side in (DURING, THEN) and main.needs == MOMENT else None
        if going is not None:
            who = sentence.subject(going["s"]) or main.of
            ways = ((who, going["on"]),) if going["on"] else read_directions(going, who)
            yield Reading(_build_question(main, ""), DURING, present_directions=(*main.ways, *ways), steady=True)
            for direction in (direction for _, direction in ways if direction in ("up", "down")):  # on the way back
                yield Reading(_build_question(main, f"{who} stopped"), AFTER, ((who, f"{THEN_GOES}{direction}"),))


def _not_meant(main: Main, when: When, clause: str, side: str) -> bool:
    """Return whether a main clause and a moment do not form a meaningful question.

    Nobody asks for the potential energy in an impact, for an angle of deflection before the collision, or for a sum
    from the start until some time after a later event. An angle *after* an event is not counted from the start.
    """
    if main.find == "potential energy":
        return side == THEN and _IMPACT.fullmatch(clause) is not None
    if main.find == DEFLECTION:
        return side in (THEN, DURING) and when.told.endswith(" before")
    if main.find in ROTATION_QUANTITIES and side == AFTER and _late(clause) and not _BEGUN.fullmatch(clause):
        return True
    return LATE_TIME_PATTERN.match(when.told) is not None and main.needs in (STRETCH, *CHANGES)


def _on_the_way(main: Main, clause: str, side: str, sentence: TokenizedSentence) -> Iterator[Reading]:
    """Yield readings for the upward or downward part of a path, until the body turns back or slipping stops."""
    alone = sentence.subject("@0@") if len(sentence.subjects) == 1 else ""
    adds_up = main.needs == STRETCH or main.find in ROTATION_QUANTITIES
    if side not in (DURING, THEN) or not adds_up or not (main.of or alone):
        return
    slips = _SLIPPING.fullmatch(clause)
    if slips is not None:
        yield _with(main, When(f"{sentence.subject(slips['s']) or main.of or alone} stopped slipping", AFTER))
    match = _ON_ITS_WAY.fullmatch(clause)
    if match is not None:
        direction = match["on"] or ("up" if match["noun"] in RISES else "down")
        who = sentence.subject(match["s"]) or main.of or alone
        for rank, when in enumerate(("highest point" if direction == "up" else "lowest point", "stopped")):
            yield _with(replace(main, rank=main.rank + rank), When(f"{who} {when}", AFTER, ((who, direction),)))


def _whole(main: Main) -> Iterator[Reading]:
    """Yield readings of a distance asked for without a moment: up to the landing, the bounce or the body's stop."""
    direction = next((direction for _, direction in main.ways if direction in ("up", "down", "right", "left")), "")
    for rank, when in enumerate(("landed", "bounced", "halted", "stopped")):
        moment = When(f"{main.of} {when}".strip(), AFTER, () if direction or when != "stopped" else ((main.of, RESTS),))
        yield _with(replace(main, rank=main.rank + rank), moment)


def _read_until_end(main: Main) -> Iterator[Reading]:
    """Yield readings of an extreme or total of a non-periodic motion, up to the time after which nothing changes."""
    if not main.find.startswith(("greatest", "least", "energy")):
        return
    if not main.find.startswith("energy"):
        yield _with(replace(main, rank=main.rank + 1), When(LONG, AFTER))
    for rank, when in enumerate((f"{main.of} halted", f"{main.of} stopped", "halted", "stopped", "landed"), start=2):
        ways = () if "stopped" not in when else ((main.of, RESTS),)
        yield _with(replace(main, rank=main.rank + rank), When(when.strip(), AFTER, ways))


def _late(clause: str) -> bool:
    """Return whether a clause names an event rather than a number, so that *after* it is not counted from the start."""
    return "#" not in clause


def _alone(main: Main) -> Iterator[Reading]:
    if main.when is not None:
        yield _with(main, main.when)
    elif main.needs == STRETCH and main.find in ("displacement", "distance travelled"):
        yield from _whole(main)
    elif main.find != "time" and main.needs not in (CLAUSED, LANDING, *CHANGES):
        yield Reading(
            _build_question(main, ""), present_directions=main.ways, steady=main.needs == MOMENT, rank=main.rank
        )
        if main.needs == STRETCH:
            yield from _read_until_end(main)


def _with(main: Main, when: When) -> Reading:
    side = AFTER if main.needs == STRETCH else when.side
    if MINUS in when.told:
        return Reading(_build_question(main, when.told), AFTER, (*main.ways, *when.ways), rank=main.rank + when.rank)
    moment = when.told.removesuffix(" before") if main.find == "time" else when.told
    if main.needs == STRETCH and main.find != "time":
        moment = moment.removesuffix(" before")
    elif (
        when.side == BEFORE and main.find != "time" and not moment.endswith(" before") and not moment.startswith("at ")
    ):
        moment = f"{moment} before"
    moves = main.needs == MOMENT or main.find == INCLINATION
    gone, moving = ((), main.ways) if moves else (main.ways, ())
    return Reading(_build_question(main, moment), side, (*gone, *when.ways), moving, rank=main.rank + when.rank)


def _build_question(main: Main, when: str) -> StructuredQuestion:
    return StructuredQuestion(main.find, main.of, when, main.along)


@dataclass(frozen=True)
class UnderstoodQuestion:
    """A sentence understood: the structured question, the posed question, and the answer with its motion."""

    asked: StructuredQuestion
    posed_question: PosedQuestion
    simulated_answer: SimulatedAnswer


class Reader(NamedTuple):
    """The functions that read questions about a scene as it is.

    `read` returns the meaning of a heard sentence, `readings` all its readings, and `first_of` the meaning of the first
    reading that the scene answers.
    """

    read: Callable[[TokenizedSentence, FollowedMotion, Words], UnderstoodQuestion | None]
    readings: Callable[[TokenizedSentence, FollowedMotion, Words], list[Reading]]
    first_of: Callable[[list[Reading], FollowedMotion, Words], UnderstoodQuestion | None]
