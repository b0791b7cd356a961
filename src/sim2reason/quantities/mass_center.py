"""The motion of the centre of mass of everything, for questions of people: recipes do not ask for it."""

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.kinematics import Velocity
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
        heavy = [body.name for body in state.mechanism.bodies if body.mass > 0.0]
        masses = [np.asarray(state.mass(name)) + np.zeros(len(state.times)) for name in heavy]
        momentum = sum(m[:, None] * Velocity.evaluate(state, name) for m, name in zip(masses, heavy, strict=True))
        return np.asarray(momentum / sum(masses)[:, None])
