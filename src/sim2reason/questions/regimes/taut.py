"""Whether a string pulls."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from typing import Self

from sim2reason.quantities.subjects.strings import Strings
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words

SLACK = 1e-9  # N


@REGIMES.register("taut")
@dataclass(frozen=True, slots=True)
class StaysTaut(Regime):
    """A string stays taut."""

    of = Strings()

    @classmethod
    def possible(cls, study: Study, words: Words) -> Sequence[Self]:
        """Every string."""
        del study
        return [cls(name) for name in words.called(cls.of)]

    def holds(self, study: Study, until: float) -> bool:
        """Whether there is a tension throughout."""
        scan = study.trace.scan
        return bool((scan.tension[self.name][scan.times <= until] > SLACK).all())

    def always_told(self, study: Study) -> bool:
        """Where the text says what happens if the string goes slack, as if it did."""
        owner = self.name.partition(".")[0]
        return any(named.entity.slackens for named in study.scene.entities if named.name == owner)

    def is_lost(self, study: Study) -> bool:
        """Where it goes slack."""
        return not self.holds(study, inf)

    def clause(self, words: Words) -> str:
        """As in: the string stays taut."""
        return f"{words.called(self.of)[self.name]} stays taut"
