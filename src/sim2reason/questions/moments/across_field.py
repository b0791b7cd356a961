"""The first time that the velocity of a body is perpendicular to the electric field."""

from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.fields import Push
from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Velocity
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.charged import SLIGHT, ActingFields, FieldPassage, begins
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@MOMENTS.register("across_field")
@dataclass(frozen=True, slots=True)
class AcrossField(FieldPassage):
    """The first time that a body has turned back along the electric field, while it still moves across it."""

    label = "turning point along the field"
    hangs_on = "velocity"
    verb = Verb("moves perpendicular to the electric field", "move perpendicular to the electric field")

    @classmethod
    def suits(cls, acts: ActingFields) -> bool:
        """Return whether there is one electric field, which does not change with time, and no medium."""
        return len(acts.electric) == 1 and acts.electric[0].profile.steady and not acts.medium

    @property
    def tells(self) -> tuple[Channel, ...]:
        """Return what follows at once from the velocity or the displacement, as forces are along the field then."""
        told = ("acceleration", "net force", "electric potential energy")
        return tuple(Channel(self.name, quantity) for quantity in told)

    def time(self, trace: Trace) -> float | None:
        """Return when the component along the field is first zero, s; None where the body is at rest then."""
        time = FieldPassage.time(self, trace)
        if time is None:
            return None
        fastest = float(np.linalg.norm(Velocity.evaluate(trace.scan, self.name), axis=1).max())
        here = float(np.linalg.norm(Velocity.evaluate(trace.at(time), self.name)))
        return time if here > SLIGHT * fastest else None

    def excess(self, state: State) -> Array:
        """Return the component along the field with the sign that is negative at first, m/s, (n,)."""
        laws = [force.law for force in state.mechanism.forces if force.body == self.name]
        way = next(np.array(law.direction) for law in laws if isinstance(law, Push))
        velocity, acceleration = begins(state, self.name)
        along = float(velocity @ way)
        first = along if abs(along) > SLIGHT * float(np.linalg.norm(velocity)) else float(acceleration @ way)
        return -np.sign(first) * (Velocity.evaluate(state, self.name) @ way)
