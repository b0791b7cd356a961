"""All of a motion that repeats itself."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.questions.moments import MOMENTS, Moment
from sim2reason.questions.recurrence import drift_return, first_return
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace


@MOMENTS.register("whole_motion")
@dataclass(frozen=True, slots=True)
class WholeMotion(Moment):
    """The end of the first round of a motion that repeats itself: nothing that comes later is new."""

    kind = "extremum"
    label = "whole motion"

    drifts: bool = False  # whether it may end elsewhere: for what does not depend on the place

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """One, if the motion repeats itself."""
        del words, rng
        return [moment] if study.time(moment := cls()) is not None else []

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """It has no number or name of its own."""
        del text, trace, words
        yield cls()

    @property
    def comes_round(self) -> bool:
        """All must be as it was."""
        return True

    def time(self, trace: Trace) -> float | None:
        """When all is as at the start again."""
        time = first_return(trace)
        return drift_return(trace) if time is None and self.drifts else time

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: in the motion that follows."""
        del words
        return ("in the motion that follows", "during the motion that follows", "in the course of the motion")
