"""Whether what hangs on a string swings right round while the string stays taut."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import inf
from typing import Self

import numpy as np

from sim2reason.quantities.subjects.swinging_lines import SwingingLines
from sim2reason.questions.outcomes import OUTCOMES, Swinging
from sim2reason.questions.outcomes.goes_slack import GoesSlack
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

STILL = 1e-3  # of its greatest speed: what is slower where it goes neither up nor down turns back


@OUTCOMES.register("circles")
@dataclass(frozen=True, slots=True)
class Circles(Swinging):
    """What hangs on a string swings right round, its string always taut; only people ask about it."""

    of = SwingingLines()
    tells = False

    @classmethod
    def found(cls, words: Words) -> Sequence[Self]:
        """None: recipes do not ask about it."""
        del words
        return ()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Strings that swing and are set moving; by falling alone nothing gets over the top."""
        return {} if words.released else GoesSlack.candidates(words)

    def happens(self, trace: Trace) -> bool | None:
        """Whether it gets over the top before the string goes slack, or what hangs on it turns back."""
        upright = {c.name for c in trace.mechanism.coordinates if c.axis[2] != 0.0}
        turned = [event.time for event in trace.events if event.kind == "turn" and event.subjects[0] in upright]
        slack = [event.time for event in trace.events if event.kind == "slack" and event.subjects[0] == self.name]
        fastest = float(np.linalg.norm(trace.scan.v, axis=1).max())
        back = [time for time in turned if np.linalg.norm(trace.at(time).v[0]) <= STILL * fastest]
        extremes = [time for time in turned if time not in back]
        end = min((*slack, *back), default=inf)
        over = extremes[1] if len(extremes) > 1 else inf  # the second of its lowest and its highest point
        return None if end == over else over < end

    def excess(self, trace: Trace) -> float:
        """The least tension."""
        return GoesSlack(self.name).excess(trace)

    def does(self, words: Words) -> tuple[str, ...]:
        """As in: the ball goes right round with the string always taut."""
        return (f"{self.subject(words)} stays taut all the way round",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """As in: the string does not stay taut all the way round."""
        return (f"{self.subject(words)} does not stay taut all the way round",)
