"""The first time that a spring has its natural length."""

from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.springs import Extension
from sim2reason.quantities.subjects.springs import Springs
from sim2reason.questions.crossing import first_crossing
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.passage import Passage
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace

RELAXED = 1e-9  # of its greatest extension


@MOMENTS.register("natural_length")
@dataclass(frozen=True, slots=True)
class NaturalLength(Passage):
    """The first time, after the start, that a spring is neither stretched nor compressed."""

    label = "natural length"
    of = Springs()
    hangs_on = "extension"
    verb = Verb("has its natural length", "have its natural length")

    def excess(self, state: State) -> Array:
        """How far it is stretched."""
        return Extension.evaluate(state, self.name)

    def time(self, trace: Trace) -> float | None:
        """Whichever comes first: it was shorter before, or longer; None if it begins so."""
        if abs(float(self.excess(trace.scan)[0])) <= RELAXED * float(np.abs(self.excess(trace.scan)).max()):
            return None
        found = [first_crossing(trace, self.excess), first_crossing(trace, lambda state: -self.excess(state))]
        return min((time for time in found if time is not None), default=None)

    @property
    def tells(self) -> tuple[Channel, ...]:
        """That it is not stretched."""
        return self.channels
