"""Motion of the centre of mass of all bodies; used in structured questions only, never drawn by recipes."""

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

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether there are several bodies with a mass and all of them can move."""
        del name
        heavy = [body.name for body in mechanism.bodies if body.mass > 0.0]
        return len(heavy) > 1 and all(moves(mechanism, each) for each in heavy)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return Σ m v / Σ m in m/s, (n, 3)."""
        del subject
        mass, momentum = np.zeros((len(state.times), 1)), np.zeros((len(state.times), 3))
        for body in state.mechanism.bodies:
            if body.mass > 0.0:
                mass = mass + np.asarray(state.mass(body.name)).reshape(-1, 1)
                momentum = momentum + Momentum.evaluate(state, body.name)
        return momentum / mass
