"""The first time that the velocity of a body is perpendicular to the electric field."""

import math
from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from sim2reason.dsl.fields import Push
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.vectors import Vector, inner
from sim2reason.quantities.kinematics import Velocity
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.charged import SLIGHT, ActingFields, FieldPassage, begins
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@MOMENTS.register("across_field")
@dataclass(frozen=True, slots=True)
class AcrossField(FieldPassage):
    """The first time that a body has turned back along the electric field, while it still moves across it."""

    label = "turning point along the field"
    hangs_on = "velocity"
    verb = Verb("moves perpendicular to the electric field", "move perpendicular to the electric field")
    again: ClassVar[Verb] = Verb(f"{verb.told} again", f"{verb.asked} again")

    @classmethod
    def suits(cls, acts: ActingFields) -> bool:
        """Return whether there is one electric field, which does not change with time, and no medium."""
        return len(acts.electric) == 1 and acts.electric[0].profile.steady and not acts.medium

    def does(self, words: Words) -> Verb:
        """Return *moves … again* for a body that is launched perpendicular to the field."""
        mechanism = words.mechanism
        way = _field_direction(mechanism, self.name)
        own = mechanism.body[self.name].coordinates
        along = sum(inner(way, one.axis) * one.speed for one in own)
        speed = math.hypot(*(one.speed for one in own))
        return self.again if abs(along) <= SLIGHT * speed and speed else self.verb

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
        way = np.array(_field_direction(state.mechanism, self.name))
        velocity, acceleration = begins(state, self.name)
        along = float(velocity @ way)
        first = along if abs(along) > SLIGHT * float(np.linalg.norm(velocity)) else float(acceleration @ way)
        return -np.sign(first) * (Velocity.evaluate(state, self.name) @ way)


def _field_direction(mechanism: Mechanism, name: str) -> Vector:
    """Return the direction of the electric force on a body."""
    laws = (force.law for force in mechanism.forces if force.body == name)
    return next(law.direction for law in laws if isinstance(law, Push))
