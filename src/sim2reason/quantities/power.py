"""The power of forces: force times velocity. Recipes do not ask for it."""

import numpy as np

from sim2reason.dsl.mechanism import ZERO, ConstantTension, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.momentum import NetForce
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import center_path, is_welded_part
from sim2reason.quantities.subjects.strings import Strings
from sim2reason.quantities.tension import StringLengthRate


class PowerOfForce(Quantity):
    """Base class of quantities that are the power of a force on a body, in W."""

    unit, symbol = "W", "P"
    of = Bodies()
    drawn_by_recipes = False
    floor, heavy = 0.1, True


@quantity
class NetPower(PowerOfForce):
    """The power of the net force on a body."""

    name = "power of the net force"
    magnitude = "the magnitude of the power of the net force on {body}"
    needs = ("mass",)
    order = 20

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body is not welded to others."""
        return not is_welded_part(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """F·v, (n,), in W, with the velocity of the centre of mass."""
        return np.einsum("ij,ij->i", NetForce.evaluate(state, subject), Velocity.evaluate(state, subject))


@quantity
class GravityPower(PowerOfForce):
    """The power of the weight of a body in a uniform field."""

    name = "power of gravity"
    magnitude = "the magnitude of the power of gravity on {body}"
    needs = ("mass",)
    order = 21

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether there is a uniform field and the body rises or falls."""
        return mechanism.gravity != ZERO and center_path(mechanism, name).rises

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """M g·v, (n,), in W."""
        return state.mass(subject) * (Velocity.evaluate(state, subject) @ np.array(state.mechanism.gravity))


@quantity
class HandPower(PowerOfForce):
    """The power of a hand that draws in a string with a constant force."""

    name = "power of a hand"
    of = Strings()
    order = 23

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of the strings that a hand draws in."""
        return tuple(line.name for line in mechanism.pulls)

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether a hand draws the string in."""
        return name in self.subjects(mechanism)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Force × the rate at which the string is drawn in, (n,), in W."""
        law = state.mechanism.line[subject].law
        assert isinstance(law, ConstantTension)
        return -law.force * StringLengthRate.evaluate(state, subject)
