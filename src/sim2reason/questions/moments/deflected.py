"""The first time that a string or a rod makes a stated angle with the vertical."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.inclination import Deflection, deflection_at_start
from sim2reason.quantities.subjects.swinging_lines import SwingingLines
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.parts.passage import Threshold
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.spoken import spoken
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace

STRAIGHT_UP = 180.0  # degrees
FEWEST = 10.0  # degrees of a swing, and from its ends


@MOMENTS.register("deflected")
@dataclass(frozen=True, slots=True)
class Deflected(Threshold):
    """The first time that a line that swings makes a stated angle with the downward vertical."""

    label = "deflection"
    of = SwingingLines()
    verb = Verb("makes", "make")
    hangs_on = "deflection"
    unit = "deg"

    @classmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """An angle between the least and the greatest, in fives of degrees, or in tens if it has three digits."""
        angles = Deflection.evaluate(trace.scan, name)
        low, high = float(np.nanmin(angles)), float(np.nanmax(angles))
        if high - low < FEWEST:
            return None
        angle = spoken(5.0 * max(1, round((low + rng.uniform(0.15, 0.85) * (high - low)) / 5.0)))
        return angle if low < angle < high else None

    @property
    def tells(self) -> tuple[Channel, ...]:
        """The angle, and so by how much the line has turned."""
        return (*self.channels, Channel(self.name, "angle turned"))

    def excess(self, state: State) -> Array:
        """How far it is beyond the angle, seen from where it starts."""
        beyond = Deflection.evaluate(state, self.name) - self.value
        return beyond if deflection_at_start(state, self.name) < self.value else -beyond

    def across(self, trace: Trace) -> Sequence[float] | None:
        """As much larger than the angle at the start as it is smaller than that, or the other way round."""
        start = deflection_at_start(trace.state, self.name)
        other = start * start / self.value
        return (other,) if 0.0 < other < STRAIGHT_UP else None

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: when the string first makes an angle of 20° with the downward vertical."""
        line, angle = self.subject(words), f"an angle of {words.say(self.value, self.unit)} with the downward vertical"
        return (
            f"when {line} first makes {angle}",
            f"at the moment when {line} first makes {angle}",
            f"when {line} makes {angle} for the first time",
        )

    def clause(self, words: Words) -> Clause | None:
        """As in: the string first makes an angle of 20° with the downward vertical."""
        angle = f"an angle of {words.say(self.value, self.unit)} with the downward vertical"
        return Clause(self.subject(words), "does", f"first make {angle}", f"first makes {angle}")
