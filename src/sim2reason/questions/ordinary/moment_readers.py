"""Readers of clauses that name a moment: each yields all moments that its clause may mean."""

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from math import tau

from sim2reason.questions.ordinary.clause_heads import HOME
from sim2reason.questions.ordinary.hearing import ALL_WORD, TokenizedSentence
from sim2reason.questions.ordinary.moment_phrases import (
    AFTER,
    BEFORE,
    DURING,
    LONG,
    ONLY_LINE,
    THEN,
    When,
    read_directions,
)
from sim2reason.questions.ordinary.vocabulary import (
    CARRIED_AT_REST,
    COMPRESSED,
    DIES_AWAY,
    DIRECTION_WORDS,
    GROUNDS,
    ON,
    QUANTITIES,
    SETS_OFF,
    STRAIGHT,
    matching_entry,
)

LINES = "horizontal", "vertical", "x", "y"
LIFT_OFF = re.compile(r"\b(?:lift(?:s|ing|ed)?|tak(?:e|es|ing))[ -]?off\b")
UP_WAY, DOWN_WAY = "up", "down"
_SLOPING = re.compile(rf"\b(?:{GROUNDS}|uphill|downhill|its path)\b")
_LENGTH = re.compile(r" (?:m|km|cm|mm|au)$")
_FROM_START = re.compile(rf"(?:\bis|\bare|\bbe|@)(?: first| again)? #\d+# (?:away )?from (?:{HOME})")
LAST_RANK = 10  # the rank of a meaning that counts only if all other meanings fail in the scene
Reader = Callable[[re.Match[str], TokenizedSentence, str, str], Iterator[When]]
"""From what matched, the sentence, the subject of the question, and the side, to all moments that may be meant."""


def subject_of(match: re.Match[str], sentence: TokenizedSentence, subject: str) -> str:
    """Return the phrase for the subject of a clause, by default that of the question."""
    return sentence.subject(match.groupdict().get("s")) or subject


def subject_moment_reader(name: str, side: str = "") -> Reader:
    """Return a reader for a named moment of one subject, such as *stopped*."""

    def read(found: re.Match[str], heard: TokenizedSentence, subject: str, asked: str) -> Iterator[When]:
        groups = found.groupdict()
        number = groups.get("number") or ""
        who = subject_of(found, heard, subject)
        yield When(" ".join(filter(None, (number, who, name))), side or asked)
        if name == "stopped":  # what rides on something comes to rest where that is at rest, too
            moment = f"velocity of {who} along {ONLY_LINE} = 0 m/s"
            yield When(moment, side or asked, ((who, CARRIED_AT_REST),), rank=LAST_RANK)
            yield When(LONG, side or asked, ((who, DIES_AWAY),))

    return read


def turned_back(name: str, presumption: str) -> Reader:
    """Return a reader for the highest or lowest point of a path or, on a straight path, for the stop of the body."""

    def read(found: re.Match[str], heard: TokenizedSentence, subject: str, asked: str) -> Iterator[When]:
        who = subject_of(found, heard, subject)
        yield When(f"{who} {name}", asked)
        yield When(f"{who} stopped", asked, ((who, presumption),), rank=LAST_RANK)

    return read


def unique_moment_reader(name: str) -> Reader:
    """Return a reader for a moment that is unique in a scene, whatever subject is named."""

    def read(found: re.Match[str], heard: TokenizedSentence, subject: str, asked: str) -> Iterator[When]:
        del found, heard, subject
        yield When(name, asked)

    return read


def velocity_jump_reader(*names: str) -> Reader:
    """Return a reader for an event at which velocities jump: just before the event, just after the event, or both."""

    def read(found: re.Match[str], heard: TokenizedSentence, subject: str, asked: str) -> Iterator[When]:
        who, groups = subject_of(found, heard, subject), found.groupdict()
        number = groups.get("number") or ""
        for name in names:
            both = _both(who, heard) if found[0].startswith("their ") or who.startswith(f"{ALL_WORD} ") else ""
            its = name != "collided" or groups.get("s") or re.match(r"its |@\d+@ 's ", found[0])
            of = both if name == "collided" and both else who if its and not who.startswith(f"{ALL_WORD} ") else ""
            moment = " ".join(filter(None, (number, of, name)))
            for side in (BEFORE, AFTER) if asked in (THEN, DURING) else (asked,):
                yield When(f"{moment} before" if side == BEFORE else moment, side)

    return read


def _both(who: str, sentence: TokenizedSentence) -> str:
    """Return the two bodies that a plural phrase means; empty unless it means two."""
    joint = [subject for subject in (who, *sentence.subjects) if subject.startswith(f"{ALL_WORD} ")]
    both = joint[0].removeprefix(f"{ALL_WORD} ") if joint else ""
    return both if both.count(" & ") == 1 else ""


def read_pair_collision(
    match: re.Match[str], sentence: TokenizedSentence, subject: str, requested_side: str
) -> Iterator[When]:
    """Yield the collision of two named bodies: just before the impact, just after the impact, or both."""
    del subject
    both = f"{sentence.subject(match['s'])} & {sentence.subject(match['t'])}"
    for side in (BEFORE, AFTER) if requested_side in (THEN, DURING) else (requested_side,):
        yield When(f"{both} collided{' before' if side == BEFORE else ''}", side)


def meet_again(match: re.Match[str], sentence: TokenizedSentence, subject: str, requested_side: str) -> Iterator[When]:
    """Yield a numbered collision of two named bodies."""
    for when in read_pair_collision(match, sentence, subject, requested_side):
        yield replace(when, told=f"{match['number']} {when.told}")


def read_collision_with(
    match: re.Match[str], sentence: TokenizedSentence, subject: str, requested_side: str
) -> Iterator[When]:
    """Yield the collision of the question's subject with a named body."""
    if subject and subject != sentence.subject(match["t"]) and not subject.startswith(f"{ALL_WORD} "):
        both = f"{subject} & {sentence.subject(match['t'])}"
        for side in (BEFORE, AFTER) if requested_side in (THEN, DURING) else (requested_side,):
            yield When(f"{both} collided{' before' if side == BEFORE else ''}", side)


def landed(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the landing and the bounce of a body, just before the impact unless the question asks for just after."""
    who = subject_of(match, sentence, subject)
    number = match.groupdict().get("number") or ""
    if side != AFTER and number in ("", "first"):
        yield When(f"{who} landed", BEFORE)
    yield When(" ".join(filter(None, (number, who, "bounced", "" if side == AFTER else "before"))), side)
    yield from velocity_jump_reader("edge landed")(match, sentence, subject, side)


def read_joint_motion(
    match: re.Match[str], sentence: TokenizedSentence, subject: str, requested_side: str
) -> Iterator[When]:
    """Yield the moment from which bodies move together, when slipping ends."""
    yield When("stopped slipping", BEFORE if requested_side == BEFORE else AFTER)
    both = _both(subject_of(match, sentence, subject), sentence)
    if both:
        yield When(f"relative velocity of {both} along {ONLY_LINE} = 0 m/s", requested_side, rank=LAST_RANK)


def with_last_rank(reader: Reader) -> Reader:
    """Return a reader for the moments of another reader, tried only after all other meanings of a clause."""

    def read(found: re.Match[str], heard: TokenizedSentence, subject: str, asked: str) -> Iterator[When]:
        yield from (replace(when, rank=when.rank + LAST_RANK) for when in reader(found, heard, subject, asked))

    return read


def read_displacement(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body has moved a given distance, or the given time if the number is a time."""
    who, number = subject_of(match, sentence, subject), sentence.number(match["n"])
    axis = matching_entry(DIRECTION_WORDS, match.groupdict().get("way") or "")
    ways = tuple(
        (body, direction) for body, direction in read_directions(match, who) if direction != axis or axis not in LINES
    )
    if is_time(number):
        yield When(f"at {number}", side, ways)
    elif axis in LINES:
        sign = "-" if axis == "vertical" and (who, DOWN_WAY) in ways else ""
        yield When(f"displacement of {who} along {axis} = {sign}{number}", side, ways if axis == "vertical" else ())
    else:
        yield When(f"{who} moved {number}", side, ways)
        if _FROM_START.search(sentence.text) is not None:  # where it may be after it has turned back, too
            yield When(f"displacement of {who} = {number}", side, ways)
        yield When(f"{who} away {number}", side, (*ways, (who, STRAIGHT)), rank=LAST_RANK)
        along = _SLOPING.search(match[0]) is not None  # then it is no height
        for sign in (
            "-" if direction == DOWN_WAY else ""
            for _, direction in ways
            if direction in (UP_WAY, DOWN_WAY) and not along
        ):
            yield When(f"displacement of {who} along vertical = {sign}{number}", side, ways, rank=LAST_RANK)


def read_path_length(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when the subject of a question has moved a length that stands alone, as in *after 3 m*."""
    number = sentence.number(match["n"])
    if side in (AFTER, DURING) and _LENGTH.search(number) is not None:
        yield When(f"{subject} moved {number}", side)


def read_relative_displacement(
    match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str
) -> Iterator[When]:
    """Yield the moment when a body has moved a distance along its carrier."""
    who = sentence.subject(match["s"]) or subject
    moment = f"displacement relative to its carrier of {who} = {sentence.number(match['n'])}"
    yield When(moment, side, ((who, f"{ON}{sentence.subject(match['t'])}"),) if match["t"] else ())


def read_return(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body on a straight line is back where it started."""
    who = subject_of(match, sentence, subject)
    yield When(f"displacement of {who} along {ONLY_LINE} = 0 m", side)
    yield When(f"{who} returned", side)


def stops_going(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body that moves in one direction comes to rest."""
    for when in subject_moment_reader("stopped")(match, sentence, subject, side):
        yield replace(when, ways=(*when.ways, *read_directions(match, subject_of(match, sentence, subject))))


def has_component(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a component of a velocity has a given value, downwards if the body falls."""
    who, sign = subject_of(match, sentence, subject), "-" if match["sense"] in ("falls", "down") else ""
    yield When(f"velocity of {who} along {match['axis']} = {sign}{sentence.number(match['n'])}", side)


def read_coordinate(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a coordinate of a body has a given value."""
    who, axis = subject_of(match, sentence, subject), match["axis"]
    value = f"{'-' if match['sign'] else ''}{sentence.number(match['n'])}"
    yield When(f"{axis} coordinate of {who} = {value}", side)


def quantity_is(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a quantity named by a noun has a given value."""
    name, who = matching_entry(QUANTITIES, match["q"]), subject_of(match, sentence, subject)
    if name == "compression":
        yield When(f"extension of {who} along stretched = -{sentence.number(match['n'])}", side, ((who, COMPRESSED),))
    if name not in ("height", "distance", "length", "force", "compression", "deceleration"):
        yield When(f"{name} of {who} = {sentence.number(match['n'])}", side)
    elif name == "height":
        yield When(f"height above the ground of {who} = {sentence.number(match['n'])}", side)


def read_component_sign(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when the vertical component of a velocity or an acceleration has a given value."""
    sign = "-" if match["up"] == "down" else ""
    yield When(
        f"{match['q']} of {subject_of(match, sentence, subject)} along up = {sign}{sentence.number(match['n'])}", side
    )


def read_time(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment at a stated time, presuming, for a time after lift-off, that the body lifts off at once."""
    number = sentence.number(match["n"])
    ways = ((subject, SETS_OFF),) if LIFT_OFF.search(sentence.text) is not None else ()
    if is_time(number):
        yield When(f"at {number}", THEN if side == AFTER else side, ways)


def second(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment 1 s after the start, the end of the first second of the motion."""
    del match, sentence, subject
    yield When("at 1 s", side)


def has_speed(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body has a given speed."""
    yield When(f"velocity of {subject_of(match, sentence, subject)} = {sentence.number(match['n'])}", side)


def angle(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a line makes a given angle with the vertical."""
    yield When(f"{subject_of(match, sentence, subject)} deflected {sentence.number(match['n'])}", side)


def read_turn(match: re.Match[str], sentence: TokenizedSentence, subject: str, side: str) -> Iterator[When]:
    """Yield the moment when a body has turned through a given angle."""
    who, number = subject_of(match, sentence, subject), sentence.number(match["n"])
    yield When(f"{who} turned through {number}", side)
    value, _, unit = number.partition(" ")
    if unit in ("°", "rad"):  # of what rolls
        turns = float(value) / (360.0 if unit == "°" else tau)
        yield When(f"revolutions made of {who} = {turns:.15g}", side, rank=LAST_RANK)


def apsis_reader(name: str) -> Reader:
    """Return a reader for the moment when two bodies are farthest apart or closest together.

    They are the two that are named, or the body of which the question is asked and its only partner.
    """

    def read(found: re.Match[str], heard: TokenizedSentence, subject: str, asked: str) -> Iterator[When]:
        named = [heard.subject(found.groupdict().get(key)).removeprefix(f"{ALL_WORD} ") for key in "st"]
        both = " & ".join(phrase for phrase in named if phrase)
        for rank, who in enumerate(dict.fromkeys((both or subject, subject, ""))):
            yield When(f"{who} {name}".strip(), asked, rank=rank)

    return read


def is_time(number: str) -> bool:
    """Return whether a number is a time."""
    return number.partition(" ")[2] in ("s", "yr")
