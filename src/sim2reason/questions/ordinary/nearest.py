"""Suggested questions about a scene, nearest to a sentence that is not understood."""

import re
from collections.abc import Iterator

import numpy as np

from sim2reason.questions.following import FollowedMotion, simulate_until_event
from sim2reason.questions.kinds import KINDS, moments_by_cause
from sim2reason.questions.moments import Happening, Moment
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.ordinary.absent import missing_object
from sim2reason.questions.ordinary.beyond import reason
from sim2reason.questions.posing import PosedQuestion
from sim2reason.questions.query import Query, targets
from sim2reason.questions.words import Words

MAX_SUGGESTIONS = 3
COMMON = frozenset(
    re.split(" ", "the a an of is what how find when at in it to and does do for by with that determine")
)


def suggestion(sentence: str, motion: FollowedMotion, words: Words) -> str:
    """Return a hint for a sentence that is not understood: the reason, if known, and similar questions."""
    why = missing_object(sentence, motion.study.scene) or reason(sentence)
    said = _words(sentence)
    offered = dict.fromkeys(question.sentence(words) for question in _offered(motion, words))
    ranked = sorted((told for told in offered if told), key=lambda told: -len(said & _words(told)) / len(_words(told)))
    near = [told for told in ranked if said & _words(told)][:MAX_SUGGESTIONS]
    told = f"did you mean: {' or: '.join(near)}" if near else "see: sim2reason ask SCENE"
    return f"{why}; {told}" if why else told


def _words(sentence: str) -> set[str]:
    return set(re.findall(r"[a-z]+", sentence.lower())) - COMMON


def _offered(motion: FollowedMotion, words: Words) -> Iterator[PosedQuestion]:
    """Yield questions for the time of each kind of event, and for every quantity at an event or a stated time."""
    study = simulate_until_event(motion).study
    rng = np.random.default_rng(0)
    moments: list[Moment] = [moment for cls in moments_by_cause() for moment in list(cls.found(study, words, rng))[:1]]
    for moment in moments:
        if isinstance(moment, Happening) and moment.clause(words) is not None:
            yield PosedQuestion(Query("time_to_event", None, moment))
        if isinstance(moment, Happening | AtTime) and KINDS[moment.kind].finds(words):
            yield from (PosedQuestion(Query(moment.kind, target, moment)) for target in targets(words))
