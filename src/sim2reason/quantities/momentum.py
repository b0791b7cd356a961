"""Momentum and its rate of change."""

from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.kinematics import Acceleration, Velocity
from sim2reason.quantities.subjects.bodies import Bodies


@quantity
class Momentum(Quantity):
    """The momentum of a body alone, whatever it carries."""

    name, unit, symbol = "momentum", "kg m/s", "p"
    of, vector = Bodies(), True
    magnitude = "the magnitude of the momentum of {body}"
    signed = "the {component}momentum of {body}"
    grounded = given = True
    needs = ("mass",)
    floor, heavy = 0.1, True
    order = 3

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """P = m v of the centre of mass, (n, 3)."""
        return state.mechanism.body[subject].mass * Velocity.evaluate(state, subject)


@quantity
class NetForce(Quantity):
    """The sum of all forces on a body alone."""

    name, unit, symbol = "net force", "N", "F"
    of, vector = Bodies(), True
    magnitude = "the magnitude of the net force on {body}"
    signed = "the {component}net force on {body}"
    immediate = True
    needs = ("mass",)
    floor, heavy = 0.1, True
    order = 4

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """F = m a, (n, 3)."""
        return state.mechanism.body[subject].mass * Acceleration.evaluate(state, subject)
