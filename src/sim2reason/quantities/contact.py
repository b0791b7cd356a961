"""What a face does to the body that lies on it; the body does the opposite to the face."""

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.subjects.contacts import Contacts


@quantity
class NormalForce(Quantity):
    """The force along the contact's normal on the body that rests."""

    name, unit, symbol = "normal force", "N", "N"
    of = Contacts()
    magnitude = "the magnitude of the normal force exerted on {body} by {surface}"
    needs = ("mass",)
    immediate = True
    floor, heavy = 0.1, True
    panel, order = "normal force", 0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Never negative but on faces that hold both ways, (n,)."""
        return state.normal[subject]


@quantity
class FrictionForce(Quantity):
    """The force on the body that rests along the direction in which it slips, with sign."""

    name, unit, symbol = "friction force", "N", "f"
    of = Contacts()
    magnitude = "the magnitude of the friction force exerted on {body} by {surface}"
    needs = ("mass",)
    immediate = True
    weight = 8.0  # where a face is rough, it should be asked about as often as a velocity
    floor, heavy = 0.1, True
    order = 1

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Static or kinetic, (n,)."""
        return state.friction[subject]

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Only a rough face has any."""
        return mechanism.contacts[name].friction > 0.0


@quantity
class FrictionNeeded(Quantity):
    """The least coefficient of static friction that prevents slipping: the friction force over the normal force.

    It is used in structured questions only, and never drawn by recipes.
    """

    name, unit, symbol = "coefficient of friction needed", "", "μ"
    of = Contacts()
    drawn_by_recipes = False
    floor = 0.1

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the face is rough."""
        return mechanism.contacts[name].friction > 0.0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return |f| / |N|, (n,); zero without friction, infinite where friction acts without a normal force."""
        pressed = np.abs(state.normal[subject])
        ratio = np.divide(
            np.abs(state.friction[subject]), pressed, out=np.full(pressed.shape, np.inf), where=pressed > 0
        )
        return np.where(state.friction[subject] == 0.0, 0.0, ratio)
