"""Any time after the start, of what never changes."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.at_start import AtStart
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words


@MOMENTS.register("all_along")
@dataclass(frozen=True, slots=True)
class AllAlong(AtStart):
    """Any time after the start, of what never changes: it is read at the start."""

    label = None

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """None: whether it is one depends on what is asked."""
        del study, words, rng
        return ()

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: after release."""
        if words.released:
            return ("after release", "after the release", "in the motion after release")
        return ("during the motion", "throughout the motion", "while the motion lasts")
