"""The first time that a body that moves in a plane is a stated distance from its starting point."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.dsl.mechanism import ZERO
from sim2reason.quantities.subjects.bodies import AXES
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.questions.choices import only_falls
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.parts.charged import acting_on
from sim2reason.questions.moments.parts.distance import DistanceThreshold
from sim2reason.questions.moments.parts.verbs import Verb, when_phrases
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words

SELDOM = 0.05


@MOMENTS.register("away")
@dataclass(frozen=True, slots=True)
class Away(DistanceThreshold):
    """The first time that a body that moves freely in a plane is a stated distance from its starting point."""

    label = "away"
    verb = Verb("is", "", "is")

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return a random distance; none for a projectile, whose range and height are asked for instead.

        Seldom one in fields that turn the velocity, where how far that has turned tells more.
        """
        mechanism = study.mechanism
        thrown = only_falls(mechanism) and mechanism.gravity != ZERO
        acting = [acts for name in cls.candidates(words) if (acts := acting_on(mechanism, name)) is not None]
        if thrown or (any(acts.turning for acts in acting) and rng.random() > SELDOM):
            return []
        return super(Away, cls).found(study, words, rng)

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Bodies whose text gives their plane axes."""
        mechanism = words.mechanism
        called = words.called(cls.of).items()
        return {n: s for n, s in called if _has_axes(words, n) and not center_path(mechanism, n).straight}

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: when the puck is first 0.50 m from its starting point."""
        first = f"{self.subject(words)} is first {self.said(words)} from its starting point"
        return when_phrases(first)

    def clause(self, words: Words) -> Clause | None:
        """As in: the puck is first 0.50 m from its starting point."""
        there = f"first {self.said(words)} from its starting point"
        return Clause(self.subject(words), "is", there, f"is {there}")


def _has_axes(words: Words, name: str) -> bool:
    own = words.mechanism.body[name].coordinates
    return len(own) > 1 and all(c.label in AXES for c in own)
