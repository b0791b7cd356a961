"""The motion of the centre of mass of everything, for questions of people: recipes do not ask for it."""

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.momentum import Momentum
from sim2reason.quantities.subjects.bodies import moves
from sim2reason.quantities.subjects.whole import Whole


@quantity
class MassCenterVelocity(Quantity):
    """The velocity of the centre of mass of all bodies together, where there are several and all can move."""

    name, unit, symbol = "velocity of the centre of mass", "m/s", "v"
    of, vector = Whole(), True
    drawn_by_recipes = False
    needs = ("mass",)
    floor = 0.1

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the only name there is, or none."""
        heavy = [body.name for body in mechanism.bodies if body.mass > 0.0]
        together = len(heavy) > 1 and all(moves(mechanism, name) for name in heavy)
        return self.of.names(mechanism) if together else ()

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Σ m v / Σ m, (n, 3)."""
        del subject
        mass, momentum = np.zeros((len(state.times), 1)), np.zeros((len(state.times), 3))
        for body in state.mechanism.bodies:
            if body.mass > 0.0:
                mass = mass + np.asarray(state.mass(body.name)).reshape(-1, 1)
                momentum = momentum + Momentum.evaluate(state, body.name)
        return momentum / mass
