"""The first time that what rests on a face begins to slip."""

from dataclasses import dataclass

from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.slip_change import SlipChange
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.simulation.trace import Event, Trace


@MOMENTS.register("began_to_slip")
@dataclass(frozen=True, slots=True)
class BeganToSlip(SlipChange):
    """The first time that a body which stuck to its face, or rolled on it, begins to slip."""

    label = "slip"
    kinds = ("slip",)
    verb = Verb("begins to slip", "begin to slip")

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Whether it stuck before."""
        return event.kind == "slip" and event.subjects[0] == self.name and not self.slipped(event, trace)
