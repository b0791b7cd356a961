"""What light rods carry."""

import numpy as np

from sim2reason.dsl.mechanism import ZERO
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.triples import minus, product
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.kinematics import Acceleration
from sim2reason.quantities.subjects.hung_bodies import HungBodies
from sim2reason.quantities.subjects.paths import carried_by
from sim2reason.quantities.subjects.rods import Rods
from sim2reason.quantities.subjects.swinging_lines import pointer


@quantity
class RodForce(Quantity):
    """The force in a light rod, positive where it pulls."""

    name, unit, symbol = "rod force", "N", "T"
    of = Rods()
    magnitude = "the magnitude of the force in {rod}"
    needs = ("mass",)
    immediate = True
    weight = 2.0
    floor, heavy = 0.1, True
    panel, order = "tension", 0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """A multiplier, or of a rod on a hinge what all that it holds needs: Σ m (g − a) along it; (n,)."""
        if subject in state.mechanism.line:
            return state.tension[subject]
        (top, start), (bottom, end) = pointer(state.mechanism, subject)
        arm = minus(state.frames[bottom].point(end).place, state.frames[top].point(start).place)
        length = np.sqrt(product(arm, arm))
        along = state.vector(arm) / np.broadcast_to(length, state.times.shape)[:, None]
        total = np.zeros((len(state.times), 3))
        for body in carried_by(state.mechanism, subject):
            if body.mass:
                total = total + body.mass * (
                    np.array(state.mechanism.gravity) - Acceleration.evaluate(state, body.name)
                )
        return np.einsum("ij,ij->i", total, along)


@quantity
class RodPull(Quantity):
    """The force in a light rod that holds a small body on a moving axle; in structured questions only, never drawn."""

    name, unit, symbol = "rod pull", "N", "T"
    of = HungBodies()
    drawn_by_recipes = False
    needs = ("mass",)
    floor, heavy = 0.1, True

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """M (g − a) along the rod, (n,): positive where the rod pulls."""
        arm = minus(state.frames.center(subject).place, state.frames[subject].point(ZERO).place)
        along = state.vector(arm) / np.broadcast_to(np.sqrt(product(arm, arm)), state.times.shape)[:, None]
        force = np.array(state.mechanism.gravity) - Acceleration.evaluate(state, subject)
        return state.mechanism.body[subject].mass * np.einsum("ij,ij->i", force, along)
