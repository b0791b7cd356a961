"""Moments such as *when its speed has doubled*, *after a long time* or *2 s after the collision*, as numbers."""

import re
from dataclasses import replace

from sim2reason.errors import TextError
from sim2reason.questions.following import FollowedMotion, SimulatedAnswer
from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.questions.moments.times import WholeMotion
from sim2reason.questions.posing import PosedQuestion, pose_question
from sim2reason.questions.query import Query
from sim2reason.questions.structured import START, StructuredQuestion
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.fields import Resistance

TIMES, GREATEST, AT_BURNOUT = " times that at start", " times the greatest", " times that at burnout"
_MULTIPLE = re.compile(
    rf"(?P<find>[a-z ]+?)(?: of (?P<of>.+))? = (?P<factor>[\d.]+)(?P<ref>{TIMES}|{GREATEST}|{AT_BURNOUT})"
)
SPEEDS = {"velocity": "speed", "angular velocity": "angular speed"}  # names of greatest values


LONG, PAST = "after a long time", " after "
LATE = re.compile(rf"(?P<late>[\d.e-]+) (?P<unit>\S+){PAST}")
_LATER = re.compile(rf"{LATE.pattern}(?P<event>.*collided)")
APART = 0.3  # relative: extremes that differ by more do not belong to a steady oscillation
DOUBLINGS, SETTLED = 10, 1e-7  # doublings of the duration, and the relative change below which a value is constant


def in_numbers(asked: StructuredQuestion, motion: FollowedMotion, words: Words) -> StructuredQuestion:
    """Return a question whose relative moment, such as *when its speed has doubled*, is replaced by a value or time.

    Raises:
        TextError: there is no such quantity, or it is zero at the start, or never settles down, or nothing collides.
    """
    if asked.when == LONG:
        return _settled(asked, motion, words)
    later = _LATER.fullmatch(asked.when)
    if later is not None:
        return _later(asked, later, motion, words)
    found = _MULTIPLE.fullmatch(asked.when)
    if found is None:
        return asked
    find, of = found["find"], f" of {found['of']}" if found["of"] else ""
    if found["ref"] == GREATEST:
        initial = _greatest(StructuredQuestion(f"greatest {SPEEDS.get(find, find)}", found["of"] or ""), motion, words)
    else:
        when = "burned out" if found["ref"] == AT_BURNOUT else START
        initial = pose_question(StructuredQuestion(find, found["of"] or "", when), motion, words)
    value = initial.followed(motion).answer
    if not value:
        raise TextError("when", f"the {find} is zero at the start, or never greatest", "give a value")
    told = f"{find}{of} = {float(found['factor']) * value:.15g} {initial.unit(words)}"
    return replace(asked, when=told)


def _greatest(asked: StructuredQuestion, motion: FollowedMotion, words: Words) -> PosedQuestion:
    """Return the question for a greatest value in a periodic motion only, as other motions have no clear maximum."""
    found = pose_question(asked, motion, words)
    moment = found.query.moment
    assert isinstance(moment, WholeMotion)
    return replace(found, query=replace(found.query, moment=replace(moment, ends=False)))


def _settled(asked: StructuredQuestion, motion: FollowedMotion, words: Words) -> StructuredQuestion:
    """Return a question at a time so late that the answer, an extreme or a limit in a medium, is constant."""
    resisted = any(isinstance(force.law, Resistance) for force in words.mechanism.forces)
    if asked.find == "time" or not (resisted or asked.find.startswith(("greatest", "least"))):
        raise TextError("when", "nothing settles down here", "name a moment")
    until, unit, before = motion.study.scene.horizon, words.mechanism.units.time, list[float]()
    for _ in range(DOUBLINGS):
        told = replace(asked, when=f"at {until:.15g} {unit}")
        question = pose_question(told, motion, words)
        followed = question.followed(motion)
        answer = followed.answer
        if answer is None:
            break
        before.append(answer)
        size = SETTLED * max(map(abs, before))
        same = len(before) > 2 and all(abs(each - answer) <= size for each in before[-3:])
        if same and (resisted or _nothing_greater(question.query, followed)):
            return told
        until *= 2.0
    raise TextError("when", "it never settles down", "name a moment")


def _nothing_greater(query: Query, followed: SimulatedAnswer) -> bool:
    """Return whether an extreme recurs in the second half of the motion, or is far from all values there.

    Where many periods mix, the extremes of the second half of the motion come near to those of the first half, and
    greater ones may follow at any time.
    """
    trace, answer = followed.study.trace, followed.answer
    extreme = FUNCTIONALS[query.functional] if isinstance(query, StretchQuery) else None
    if not isinstance(extreme, Extreme) or not isinstance(query, StretchQuery) or answer is None:
        return False
    end = trace.stable_until
    late = extreme.between(trace, query.name, 0.5 * end, end)
    if late is None:
        return False
    again, size = abs(late - answer) <= SETTLED * abs(answer), max(abs(late), abs(answer))
    return again or abs(late - answer) > APART * size


def _later(asked: StructuredQuestion, found: re.Match[str], motion: FollowedMotion, words: Words) -> StructuredQuestion:
    """Return a question with a time counted from the start, for one counted from a collision."""
    began = pose_question(StructuredQuestion("time", "", found["event"]), motion, words)
    answer = began.followed(motion).answer
    if answer is None or began.unit(words) != found["unit"] or asked.find == "time":
        raise TextError("when", "there is no such collision", "name a moment")
    return replace(asked, when=f"at {answer + float(found['late']):.15g} {found['unit']}")
