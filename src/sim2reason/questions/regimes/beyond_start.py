"""On which side of where it started a line that swings makes the angle that a question speaks of."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from sim2reason.quantities.inclination import Deflection, deflection_at_start
from sim2reason.quantities.subjects.swinging_lines import SwingingLines
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words

APART = 1e-6  # degrees: less is no other angle


@REGIMES.register("beyond_start")
@dataclass(frozen=True, slots=True)
class DeflectedBeyondStart(Regime):
    """A line makes a larger angle with the vertical than at the start, or a smaller one, when something is asked."""

    of = SwingingLines()
    stage = 2

    larger: bool

    @classmethod
    def possible(cls, study: Study, words: Words) -> Sequence[Self]:
        """Either, of every line, where the question has a symbol for an angle: symbols do not say which is larger."""
        del study
        return [cls(name, larger) for name in words.called(cls.of) for larger in (True, False) if "deg" in words.own]

    def holds(self, study: Study, until: float) -> bool:
        """Whether it is so then; not where a slack string points nowhere."""
        state = study.trace.at(until)
        more = float(Deflection.evaluate(state, self.name)[0]) - deflection_at_start(state, self.name)
        return more > APART if self.larger else more < -APART

    def clause(self, words: Words) -> str:
        """As in: the string then makes a larger angle with the downward vertical than at the start."""
        size = "larger" if self.larger else "smaller"
        line = words.called(self.of)[self.name]
        return f"{line} then makes a {size} angle with the downward vertical than at the start"
