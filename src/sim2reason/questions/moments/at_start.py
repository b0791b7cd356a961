"""Just after the start."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.questions.moments import MOMENTS, Moment
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace


@MOMENTS.register("at_start")
@dataclass(frozen=True, slots=True)
class AtStart(Moment):
    """Just after the start."""

    kind = "start"
    label = "start"

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Every motion has one."""
        del study, words, rng
        return [cls()]

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """It has no number or name of its own."""
        del text, trace, words
        yield cls()

    def time(self, trace: Trace) -> float | None:
        """Zero."""
        del trace
        return 0.0

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: just after release."""
        if words.released:
            return ("just after release", "immediately after release", "at the instant of release")
        return ("just after t = 0", "immediately after t = 0", "at t = 0")
