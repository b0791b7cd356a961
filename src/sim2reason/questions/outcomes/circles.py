"""The outcome that a body on a string swings right round while the string stays taut."""

from dataclasses import dataclass
from math import inf

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
    """The outcome that a body on a string swings right round with the string always taut; only people ask about it."""

    of = SwingingLines()
    tells = False
    drawn_by_recipes = False

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the strings of bodies that are set moving; none of those released, as no body falls over the top."""
        return {} if words.released else GoesSlack.candidates(words)

    def happens(self, trace: Trace) -> bool | None:
        """Return whether the body gets over the top before the string goes slack or the body turns back."""
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
        """Return the least tension, N."""
        return GoesSlack(self.name).excess(trace)

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the string stays taut all the way round*."""
        return (f"{self.subject(words)} stays taut all the way round",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the string does not stay taut all the way round*."""
        return (f"{self.subject(words)} does not stay taut all the way round",)
