"""Whether a line that swings starts below what it hangs from."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from sim2reason.quantities.inclination import deflection_at_start
from sim2reason.quantities.subjects.swinging_lines import SwingingLines
from sim2reason.questions.regimes import REGIMES, Regime
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words

RIGHT = 90.0  # degrees


@REGIMES.register("acute")
@dataclass(frozen=True, slots=True)
class StartsAcute(Regime):
    """A line makes an acute angle with the downward vertical at the start, though another one could be stated."""

    of = SwingingLines()
    stage = 0
    at_start = True

    @classmethod
    def possible(cls, study: Study, words: Words) -> Sequence[Self]:
        """Strings, springs and the rods of bobs: which way an arm with several pieces points, their masses say too."""
        held = study.mechanism.body
        extended = {name for name, body in held.items() if not body.mass or any(body.inertia)}
        return [cls(name) for name in words.called(cls.of) if name not in extended]

    def holds(self, study: Study, until: float) -> bool:
        """Whether it is so in another motion."""
        del until
        return deflection_at_start(study.trace.at(0.0), self.name) < RIGHT

    def clause(self, words: Words) -> str:
        """As in: the rod makes an acute angle with the downward vertical at the start."""
        return f"{words.called(self.of)[self.name]} makes an acute angle with the downward vertical at the start"
