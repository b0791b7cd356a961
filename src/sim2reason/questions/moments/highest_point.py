"""The first time that a body is at the highest point of its path."""

from dataclasses import dataclass

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Displacement, Velocity
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.turning_point import TurningPoint
from sim2reason.questions.moments.parts.verbs import Verb


@MOMENTS.register("highest_point")
@dataclass(frozen=True, slots=True)
class HighestPoint(TurningPoint):
    """The first time that a body is at the highest point of its path."""

    label = "highest point"
    verb = Verb("reaches the highest point of its path", "reach the highest point of its path")
    local_verb = Verb("stops rising", "stop rising")

    def extent(self, state: State) -> Array:
        """Its height from where it began."""
        return Displacement.evaluate(state, self.name)[:, 2]

    def excess(self, state: State) -> Array:
        """How fast it falls."""
        return -Velocity.evaluate(state, self.name)[:, 2]
