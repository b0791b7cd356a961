"""The first time that a body is at the lowest point of its path."""

from dataclasses import dataclass

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Displacement, Velocity
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.turning_point import TurningPoint
from sim2reason.questions.moments.parts.verbs import Verb


@MOMENTS.register("lowest_point")
@dataclass(frozen=True, slots=True)
class LowestPoint(TurningPoint):
    """The first time that a body is at the lowest point of its path."""

    label = "lowest point"
    verb = Verb("passes through the lowest point of its path", "pass through the lowest point of its path")

    def extent(self, state: State) -> Array:
        """Its depth from where it began."""
        return -Displacement.evaluate(state, self.name)[:, 2]

    def excess(self, state: State) -> Array:
        """How fast it rises."""
        return Velocity.evaluate(state, self.name)[:, 2]
