"""Whether all strings pull."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from typing import Self

from sim2reason.quantities.subjects.strings import Strings
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.regimes.taut import StaysTaut, is_driven
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words


@REGIMES.register("all_taut")
@dataclass(frozen=True, slots=True)
class AllStayTaut(Regime):
    """All strings of several stay taut."""

    of = Strings()

    @classmethod
    def possible(cls, study: Study, words: Words) -> Sequence[Self]:
        """Once, where there are several strings; a pulley with mass parts one into several lines."""
        del words
        return [cls("")] if len({line.name.partition("/")[0] for line in study.mechanism.strings}) > 1 else []

    def holds(self, study: Study, until: float) -> bool:
        """Whether there is a tension in each throughout."""
        return all(StaysTaut(line.name).holds(study, until) for line in study.mechanism.strings)

    def always_told(self, study: Study) -> bool:
        """Where there is a spring or a hand, too, which may drive one end faster than loads can follow."""
        return is_driven(study.mechanism)

    def is_lost(self, study: Study) -> bool:
        """Where one of them goes slack."""
        return not self.holds(study, inf)

    def clause(self, words: Words) -> str:
        """As in: all strings stay taut."""
        del words
        return "all strings stay taut"
