"""What a question in ordinary English asks of a motion: all its readings must come to the same answer."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import isclose

import numpy as np

from sim2reason.errors import TextError
from sim2reason.questions.following import Followed, FollowedMotion
from sim2reason.questions.ordinary.presumed import axis_named, presumed, steady, two_sided
from sim2reason.questions.ordinary.reading import Reading, readings
from sim2reason.questions.ordinary.whens import DURING
from sim2reason.questions.posing import PosedQuestion, posed
from sim2reason.questions.words import Words

SAME = 1e-6  # relative: answers that differ by less are one


@dataclass(frozen=True)
class Understood:
    """What a sentence asks, and the answer with the motion that has it."""

    posed: PosedQuestion
    followed: Followed


def understood(sentence: str, motion: FollowedMotion, words: Words) -> Understood | None:
    """What a sentence asks, and its answer; None if it is none that is understood.

    Raises:
        TextError: it can be read in several ways, which have different answers; or what it takes for granted is not so.
    """
    found, refused = [], ""
    for reading in readings(sentence, words):
        try:
            question = posed(_placed(reading, words).asked, motion, words)
        except TextError:
            continue
        followed = question.followed(motion)
        reason = _unfit(reading, question, followed, words)
        refused = refused or reason
        if not reason:
            found.append(Understood(question, followed))
    answered = [each for each in found if each.followed.answer is not None]
    if refused and not answered:
        raise TextError("question", f"it is not so: {refused}", "ask about what happens, or say when")
    _agree(answered, words)
    return next(iter([*answered, *found]), None)


def _placed(reading: Reading, words: Words) -> Reading:
    asked = reading.asked
    if asked.along:
        asked = replace(asked, along=axis_named(asked.along, asked, words))
    return replace(reading, asked=replace(asked, when=asked.when or ("at start" if reading.steady else "")))


def _unfit(reading: Reading, question: PosedQuestion, followed: Followed, words: Words) -> str:
    """Why a reading can't be what is meant; empty if it can."""
    if followed.answer is None:
        return ""
    query, study = question.query, followed.study
    if reading.steady and query.target is not None:
        reason = steady(query.target, study.trace, during=reading.side == DURING)
        if reason:
            return reason
    elif query.target is not None and query.moment is not None and two_sided(query, study, reading.side):
        return "it changes at once at that moment; ask just before it, or just after it"
    time = study.time(query.moment) if query.moment is not None else None
    return next((reason for reason in presumed(reading, study.trace, time, words) if reason), "")


def _agree(found: list[Understood], words: Words) -> None:
    """Refuse a sentence whose readings differ, with all of them."""
    answers = [each.followed.answer for each in found]
    if all(isclose(answer or 0.0, answers[0] or 0.0, rel_tol=SAME, abs_tol=1e-12) for answer in answers):
        return
    told = list(dict.fromkeys(each.posed.sentence(words) or "…" for each in found))
    raise TextError("question", "it can be read in several ways", f"did you mean: {' or: '.join(told)}")
