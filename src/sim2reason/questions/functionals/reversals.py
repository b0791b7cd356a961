"""How often a body turns back."""

from collections.abc import Sequence

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import center_path, rides
from sim2reason.questions.choices import still
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.event_count import EventCount
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@functional
class Reversals(EventCount):
    """How often a body on a line reverses its direction of motion."""

    name = "number of reversals"
    of = Bodies()
    phrase = "the number of times that {body} reverses its direction of motion"
    how = "how many times does {body} reverse its direction of motion {when}?"
    indirect = "how many times {body} reverses its direction of motion"
    weight = 2.0

    def present(self, words: Words, name: str) -> bool:
        """What moves along one line of the room."""
        return center_path(words.mechanism, name).straight and not rides(words.mechanism, name)

    def times(self, trace: Trace, name: str) -> Sequence[float]:
        """Where the sign of its velocity changes, on a line between two instants of a scan.

        Halts without a reversal do not count.
        """
        way = np.array(center_path(trace.mechanism, name).ways[0])
        speeds = Velocity.evaluate(trace.scan, name) @ way
        clear = np.flatnonzero(np.abs(speeds) > still(trace, speeds))
        times, speeds = trace.scan.times[clear], speeds[clear]
        (before,) = np.nonzero(speeds[1:] * speeds[:-1] < 0.0)
        shares = speeds[before] / (speeds[before] - speeds[before + 1])
        return (times[before] + shares * (times[before + 1] - times[before])).tolist()

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Its velocity."""
        del mechanism
        return (Channel(name, Velocity.name),)
