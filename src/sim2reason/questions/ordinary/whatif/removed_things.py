"""Phrases that name a string, spring, hand or field removed during a motion, and the moment of the removal."""

import re
from dataclasses import replace

from sim2reason.errors import TextError
from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.following import FollowedMotion
from sim2reason.questions.ordinary.hearing import ALL, Heard
from sim2reason.questions.ordinary.meaning import Reader
from sim2reason.questions.posing import posed
from sim2reason.questions.removal import FIELDS, removable
from sim2reason.questions.structured import StructuredQuestion, measured
from sim2reason.questions.words import Words

_STRINGS = frozenset({"string", "rope", "cord", "thread"})
_MOVES = re.compile(
    r"(?P<s>@\d+@) (?:is|are|was|were|has been) (?:just )?(?P<verb>moving|sliding|rising|falling|going up|going down"
    r"|climbing|sinking)(?P<way> up(?:wards)?(?: \w+)?| down(?:wards)?(?: \w+)?)? (?:at|with)"
    r"(?: speed of)? (?P<n>#\d+#)"
)
_REACHES = re.compile(r"(?P<s>@\d+@) (?:reaches|has reached|attains|has) (?:speed of )?(?P<n>#\d+#)")
_UP = re.compile(r"rising|up|climbing")
_DOWN = re.compile(r"falling|down|sinking")


def named_things(said: str, heard: Heard, words: Words) -> tuple[str, ...]:
    """Return the names of the lines or the field that a phrase of a sentence means; none if it is not clear.

    *string* alone means the only string, and *@0@ 's string* the only one that ends at a body.
    """
    things = removable(words)
    lines = words.mechanism.lines
    owner = re.match(r"(@\d+@) 's ", said)
    if owner is not None:
        body = _body(heard.subject(owner[1]), words)
        sites = {site.name for site in words.mechanism.site.values() if site.body == body}
        found = {line.whole for line in lines if sites & {line.through[0], line.through[-1]}}
    elif said.startswith("@"):
        found = {name for name, phrase in things.items() if phrase == heard.subject(said)}
    elif said in _STRINGS:
        found = {line.whole for line in lines}
    elif said == "hand":
        found = {line.whole for line in words.mechanism.pulls}
    else:
        found = {name for name, phrase in things.items() if phrase in FIELDS.values() and phrase == f"the {said}"}
    return tuple(found) if len(found) == 1 and found <= {*things, *(line.whole for line in lines)} else ()


def _body(phrase: str, words: Words) -> str:
    return next((name for name, said in words.called(Bodies()).items() if said == phrase), "")


def time_of(stated: str, heard: Heard, words: Words) -> float | None:
    """Return the time, in the scene's unit of it, that the token of a number stands for; None if it is no time."""
    try:
        return measured("question", heard.number(stated), words.units.spell("s"))
    except TextError:
        return None


def moment_of(clause: str, heard: Heard, motion: FollowedMotion, words: Words, reader: Reader) -> float | None:
    """Return the time of the moment that a clause such as *A has slid 2 m* names; None if it is not understood."""
    moving = _MOVES.fullmatch(clause) or _REACHES.fullmatch(clause)
    if moving is not None:
        return _time_of_speed(moving, heard, motion, words)
    found = reader.read(replace(heard, text=f"how long is it until {clause}"), motion, words)
    return found.followed.answer if found is not None and found.asked.find == "time" else None


def _time_of_speed(moving: re.Match[str], heard: Heard, motion: FollowedMotion, words: Words) -> float | None:
    """Return the first time at which a body has a stated speed, s; None if it does not then move as is said."""
    phrase = heard.subject(moving["s"]).removeprefix(f"{ALL} ").partition(" & ")[0]
    body = _body(phrase, words)
    way = f"{moving.groupdict().get('verb') or ''} {moving.groupdict().get('way') or ''}"
    try:
        asked = StructuredQuestion("time", when=f"speed of {body} = {heard.number(moving['n'])}")
        followed = posed(asked, motion, words).followed(motion)
    except TextError:
        return None
    if followed.answer is None:
        return None
    rising = float(Velocity.evaluate(followed.study.trace.at(followed.answer), body)[0, 2])
    wrong = (_UP.search(way) and rising <= 0.0) or (_DOWN.search(way) and rising >= 0.0)
    return None if wrong else followed.answer
