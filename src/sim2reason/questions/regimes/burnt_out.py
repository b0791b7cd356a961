"""Whether what burns fuel has any left."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words

THEN = 1e-9  # relative: a moment that is no farther from burn-out is that


@REGIMES.register("burnt out")
@dataclass(frozen=True, slots=True)
class BurntOut(Regime):
    """The fuel is used up before the moment that is asked about, or it is not."""

    of = Bodies()

    out: bool

    @classmethod
    def possible(cls, study: Study, words: Words) -> Sequence[Self]:
        """What burns fuel."""
        named = words.called(cls.of)
        return [cls(burn.body, out) for burn in study.mechanism.burns if burn.body in named for out in (True, False)]

    def holds(self, study: Study, until: float) -> bool:
        """Whether the moment is later than burn-out, or earlier; at burn-out itself nothing need be said."""
        end = max(burn.until for burn in study.mechanism.burns if burn.body == self.name)
        return until > end * (1.0 + THEN) if self.out else 0.0 < until < end * (1.0 - THEN)

    def always_told(self, study: Study) -> bool:
        """Its symbols do not say how long it burns."""
        del study
        return True

    def clause(self, words: Words) -> str:
        """As in: the rocket has used up its fuel by then."""
        called = words.called(self.of)[self.name]
        return f"{called} has used up its fuel by then" if self.out else f"{called} still has fuel then"
