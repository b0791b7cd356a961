"""The energy that a medium takes from a body."""

import numpy as np

from sim2reason.dsl.fields import Resistance
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.triples import product
from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.integral import Integral
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel


@functional
class DragHeat(Integral):
    """The energy that a body loses to the resistance of a medium that is everywhere."""

    name, unit, least = "energy lost to drag", "J", 1e-6
    of, needs = Bodies(), ("mass",)
    phrase = "the energy that {body} loses to the resistance of the medium"
    how = "how much energy does {body} lose to the resistance of the medium {when}?"
    indirect = "how much energy {body} loses to the resistance of the medium"
    weight = 5.0

    def rate(self, state: State, name: str) -> Array:
        """−F·v, W, (n,)."""
        point, total = state.frames.center(name), np.zeros(len(state.times))
        for force in state.mechanism.forces:
            if force.body == name and isinstance(force.law, Resistance):
                pull = force.law.force(point.place, point.velocity, state.times, np)
                total = total - product(pull, point.velocity)
        return total

    def present(self, words: Words, name: str) -> bool:
        """What a medium resists."""
        drags = [f for f in words.mechanism.forces if f.body == name and isinstance(f.law, Resistance)]
        return bool(drags) and all(force.region is None for force in drags)

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Its velocity."""
        del mechanism
        return (Channel(name, Velocity.name),)
