"""The first time that a body in crossed fields has its initial velocity again."""

from dataclasses import dataclass

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Velocity
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.charged import ActingFields, FieldPassage, begins
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.simulation.trace import Trace


@MOMENTS.register("velocity_returned")
@dataclass(frozen=True, slots=True)
class VelocityReturned(FieldPassage):
    """The first time that a velocity in crossed fields has its initial value again: the end of a cyclotron period."""

    label = "velocity again"
    hangs_on = "velocity"
    verb = Verb("has its initial velocity again", "have its initial velocity again")

    @classmethod
    def suits(cls, acts: ActingFields) -> bool:
        """Return whether the fields are crossed and uniform, so that the velocity has a period."""
        return acts.uniform and bool(acts.electric) and bool(acts.magnetic)

    def time(self, trace: Trace) -> float | None:
        """Return the period of the velocity, s; None of what starts from rest, which comes to rest again."""
        velocity, acceleration = begins(trace.state, self.name)
        return FieldPassage.time(self, trace) if velocity.any() and acceleration.any() else None

    def excess(self, state: State) -> Array:
        """Return how far the velocity has changed in the direction of the initial acceleration, m²/s³, (n,)."""
        velocity, acceleration = begins(state, self.name)
        return (Velocity.evaluate(state, self.name) - velocity) @ acceleration
