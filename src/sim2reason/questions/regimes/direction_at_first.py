"""Which way a body moves first after it is released."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.regimes.direction import MovesOneWay
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words


@REGIMES.register("direction_at_first")
@dataclass(frozen=True, slots=True)
class MovesFirst(Regime):
    """A body that is released begins to move one way along a line, whatever it does later."""

    of = Bodies()
    stage = 0

    way: MovesOneWay

    @classmethod
    def possible(cls, study: Study, words: Words) -> Sequence[Self]:
        """Either way, where nothing moves at the start: else the text tells it."""
        return [cls(way.name, way) for way in MovesOneWay.possible(study, words)] if words.released else []

    def holds(self, study: Study, until: float) -> bool:
        """Whether it is about to move that way."""
        del until
        return self.way.begins(study)

    def clause(self, words: Words) -> str:
        """As in: block A first moves down the slope."""
        return f"{words.called(self.of)[self.name]} first {self.way.motion}"
