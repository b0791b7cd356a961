"""Kinetic and potential energy of each body by itself."""

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.triples import applied, product
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.kinematics import Displacement, Velocity
from sim2reason.quantities.subjects import Sense
from sim2reason.quantities.subjects.bodies import EVEN, Bodies, axes


@quantity
class KineticEnergy(Quantity):
    """The kinetic energy of a body alone, that of its turning included."""

    name, unit, symbol = "kinetic energy", "J", "K"
    of = Bodies()
    magnitude = "the kinetic energy of {body}"
    needs = ("mass",)
    given = True
    floor, heavy = 0.1, True
    order = 5

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """K = ½ m v² + ½ ω·Iω (König), (n,), with its own inertia about its centre of mass."""
        found, frame = state.mechanism.body[subject], state.frames[subject]
        speed = Velocity.evaluate(state, subject)
        energy = 0.5 * found.mass * np.einsum("ij,ij->i", speed, speed)
        if frame.spin is None:
            return energy
        spin = frame.unturned(frame.spin)
        return energy + 0.5 * product(spin, applied(found.inertia, spin))


@quantity
class PotentialEnergy(Quantity):
    """The gravitational potential energy of a body less that at the start."""

    name, unit, symbol = "potential energy", "J", "U"
    of = Bodies()
    signed = "the gain in gravitational potential energy of {body} since the start (negative for a loss)"
    sense = Sense("a gain", (0.0, 0.0, 1.0), fixed=True)
    needs = ("mass",)
    floor, heavy = 0.1, True
    order = 6

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """ΔU = −m g·s, (n,)."""
        mass = state.mechanism.body[subject].mass
        return -mass * Displacement.evaluate(state, subject) @ np.array(state.mechanism.gravity)

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Only what can rise or fall has any."""
        return any(abs(axis[2]) > EVEN for axis in axes(mechanism, name))
