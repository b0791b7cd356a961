"""The work that an electric field does on a charge."""

import numpy as np

from sim2reason.dsl.fields import Push
from sim2reason.dsl.mechanism import Force, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.triples import product
from sim2reason.quantities.kinematics import Displacement, Velocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.integral import Integral
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@functional
class FieldWork(Integral):
    """The work of the electric force on a charge, where it is positive."""

    name, unit, least = "work of an electric field", "J", 1e-6
    of, needs = Bodies(), ("charge",)
    phrase = "the work that the electric field does on {body}"
    how = "how much work does the electric field do on {body} {when}?"
    indirect = "how much work the electric field does on {body}"
    weight = 1.5

    def rate(self, state: State, name: str) -> Array:
        """F·v inside the field, W, (n,)."""
        point, total = state.frames.center(name), np.zeros(len(state.times))
        for force in _pushes(state.mechanism, name):
            pull = force.law.force(point.place, point.velocity, state.times, np)
            power = product(pull, point.velocity) + 0.0 * state.times
            if force.region is not None:
                margins = [margin + 0.0 * state.times for margin in force.region.margins(point.place, np)]
                power = np.where(np.min(margins, axis=0) > 0.0, power, 0.0)
            total = total + power
        return total

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """None where it is against the motion on the whole."""
        work = super().value(trace, name, end)
        return work if work is not None and work > 0.0 else None

    def present(self, words: Words, name: str) -> bool:
        """A charge in an electric field."""
        return bool(_pushes(words.mechanism, name))

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Where it is and how fast it moves."""
        del mechanism
        return (Channel(name, Velocity.name), Channel(name, Displacement.name))


def _pushes(mechanism: Mechanism, name: str) -> list[Force]:
    return [force for force in mechanism.forces if force.body == name and isinstance(force.law, Push)]
