"""The types of a sentence's meaning and of the reader of questions about a scene as it is."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

from sim2reason.questions.following import Followed, FollowedMotion
from sim2reason.questions.ordinary.hearing import Heard
from sim2reason.questions.ordinary.reading import Reading
from sim2reason.questions.posing import PosedQuestion
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.words import Words


@dataclass(frozen=True)
class Understood:
    """A sentence understood: the structured question, the posed question, and the answer with its motion."""

    asked: StructuredQuestion
    posed: PosedQuestion
    followed: Followed


class Reader(NamedTuple):
    """The functions that read questions about a scene as it is.

    `read` returns the meaning of a heard sentence, `readings` all its readings, and `first_of` the meaning of the first
    reading that the scene answers.
    """

    read: Callable[[Heard, FollowedMotion, Words], Understood | None]
    readings: Callable[[Heard, FollowedMotion, Words], list[Reading]]
    first_of: Callable[[list[Reading], FollowedMotion, Words], Understood | None]
