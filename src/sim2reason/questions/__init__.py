"""Questions: a mode says what is unknown, a kind what is asked of the motion, a moment when.

A `Query` is what is asked, without words; a `Question` has words and an answer.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from sim2reason.questions.kinds import KINDS, Kind
from sim2reason.questions.moments import MOMENTS, Moment
from sim2reason.questions.query import Query
from sim2reason.questions.study import Study
from sim2reason.questions.targets import Noun, Target
from sim2reason.questions.words import Words
from sim2reason.registry import Registry


@dataclass(frozen=True, slots=True)
class Question:
    """A question in words with its answer.

    `sign` is the sense that counts as positive, in words; empty for a magnitude.
    """

    mode: str
    query: Query
    text: str
    answer: float
    unit: str
    sign: str = ""


Mode = Callable[[Study, Words, str, np.random.Generator], Question | None]
"""Asks one question of a kind, or of any kind if that is empty."""

MODES: Registry[Mode] = Registry("questions.modes")

__all__ = [
    "KINDS",
    "MODES",
    "MOMENTS",
    "Kind",
    "Mode",
    "Moment",
    "Noun",
    "Query",
    "Question",
    "Study",
    "Target",
    "Words",
]
