"""The first time that a body has its greatest speed."""

from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Acceleration, Velocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.crossing import crossings
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.passage import Passage
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.recurrence import nothing_new
from sim2reason.simulation.trace import Trace

AS_FAST = 1e-6  # relative: what is slower by less is as fast


@MOMENTS.register("fastest")
@dataclass(frozen=True, slots=True)
class Fastest(Passage):
    """The first time that a body has its greatest speed, in a motion that repeats itself or ends at rest."""

    label = "greatest speed"
    drawn_by_recipes = False
    of = Bodies()
    hangs_on = "velocity"
    verb = Verb("reaches its greatest speed", "reach its greatest speed")

    def excess(self, state: State) -> Array:
        """Return −v·a, by how much half the squared speed falls per second, in m²/s³, (n,)."""
        velocity, acceleration = (found.evaluate(state, self.name) for found in (Velocity, Acceleration))
        return -np.einsum("ij,ij->i", velocity, acceleration)

    def time(self, trace: Trace) -> float | None:
        """Return when the speed first stops growing at its greatest value, s; None if it may grow later, too."""
        if not nothing_new(trace):
            return None
        greatest = float(np.linalg.norm(Velocity.evaluate(trace.scan, self.name), axis=1).max())
        for time in crossings(trace, self.excess):
            if float(np.linalg.norm(Velocity.evaluate(trace.at(time), self.name))) >= (1.0 - AS_FAST) * greatest:
                return time
        return None
