"""What moments share at which a body is a stated distance from its starting point."""

from dataclasses import dataclass

import numpy as np

from sim2reason.questions.moments.parts.passage import Threshold
from sim2reason.questions.spoken import round_number
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities.kinematics import Displacement
from sim2reason.simulation.quantities.subjects.bodies import Bodies
from sim2reason.simulation.trace import Trace

NEAREST, FARTHEST = 0.2, 0.9  # of how far the body gets
SHORTEST, LONGEST, TIED = 0.01, 9e4, 2.0  # m; strings are not longer than the last


@dataclass(frozen=True, slots=True)
class DistanceThreshold(Threshold):
    """A threshold of a body's distance from where it was at the start."""

    of = Bodies()
    hangs_on = "displacement"
    unit = "m"

    @classmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """Return a part of how far it gets."""
        reached = float(np.linalg.norm(Displacement.evaluate(trace.scan, name), axis=1).max())
        whole = min(reached, TIED if trace.mechanism.strings else LONGEST)
        distance = rng.uniform(NEAREST, FARTHEST) * whole
        return round_number(distance, NEAREST * whole, FARTHEST * whole) if distance >= SHORTEST else None

    def excess(self, state: State) -> Array:
        """Return how much farther it is than the distance."""
        return np.linalg.norm(Displacement.evaluate(state, self.name), axis=1) - self.value
