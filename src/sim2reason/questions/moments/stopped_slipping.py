"""The first time that a body that slips on a face stops slipping: it rolls, or sticks to what carries it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.questions.choices import still
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.parts.slip_change import SlipChange, rolls, slip
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

VERBS: Mapping[bool, Verb] = {
    True: Verb("begins to roll without slipping", "begin to roll without slipping"),
    False: Verb("stops sliding on {surface}", "stop sliding on {surface}"),
}


@MOMENTS.register("stopped_slipping")
@dataclass(frozen=True, slots=True)
class StoppedSlipping(SlipChange):
    """The first time that a body begins to roll without slipping, or stops sliding on a body that moves."""

    label = "stick"
    kinds = ("stick",)

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """What rolls, and what lies on something that moves; on what is fixed it would just come to rest."""
        mechanism = words.mechanism
        called = words.called(cls.of).items()
        return {n: said for n, said in called if rolls(words, n) or mechanism.body[n].parent is not None}

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Leave out what turned back before: it stopped for an instant then, and a reader may take that instant."""
        found = super(StoppedSlipping, cls).found(study, words, rng)
        return [moment for moment in found if not moment.turned_back(study.trace)]

    def turned_back(self, trace: Trace) -> bool:
        """Return whether the body slips in both senses before it stops slipping."""
        time = self.time(trace)
        slips = slip(trace.scan, self.name)
        before = slips[trace.scan.times < (time or 0.0)]
        slight = still(trace, slips)
        return bool((before > slight).any() and (before < -slight).any())

    def _verb(self, words: Words) -> Verb:
        surface, verb = words.fills(self.of, self.name)["surface"], VERBS[rolls(words, self.name)]
        return Verb(verb.told.format(surface=surface), verb.asked.format(surface=surface))

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: when the ball first begins to roll without slipping."""
        return self._verb(words).phrases(self.subject(words), 1)

    def clause(self, words: Words) -> Clause | None:
        """As in: the ball first begins to roll without slipping."""
        return self._verb(words).clause(self.subject(words), 1)
