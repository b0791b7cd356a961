"""The instant from which a body stays at rest for ever, after it has stopped before."""

from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.quantities.kinematics import Velocity
from sim2reason.questions.choices import still
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.moments.stopped import Stopped
from sim2reason.questions.recurrence import ends_at_rest
from sim2reason.simulation.trace import Event, Trace


@MOMENTS.register("halted")
@dataclass(frozen=True, slots=True)
class Halted(Stopped):
    """The last stop of a body that friction brings to rest for good, where it has had others."""

    label = "rest for good"
    kinds = ("stick",)
    most = 0
    may_touch = False
    verb = again = Verb("comes to rest for good", "come to rest for good")

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Whether it stops then, has stopped before, and nothing ever moves again."""
        if not Stopped.is_this(self, event, trace) or not ends_at_rest(trace):
            return False
        times, speeds = trace.scan.times, _speeds(trace, self.name)
        return (
            bool((speeds[times >= event.time] <= still(trace, speeds)).all())
            and Stopped(self.name).time(trace) != event.time
        )


def _speeds(trace: Trace, name: str) -> Array:
    return np.linalg.norm(Velocity.evaluate(trace.scan, name), axis=1)
