"""Force by which a fixed axle holds what turns about it."""

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.subjects import Sense
from sim2reason.quantities.subjects.axles import Axles
from sim2reason.quantities.subjects.bodies import VERTICAL
from sim2reason.quantities.supports import ForceOnAxle

FORCE = "force that the axle exerts on {body}"


@quantity
class AxleForce(Quantity):
    """The force that a fixed axle exerts on the body that turns about it."""

    name, unit, symbol = "axle force", "N", "F"
    of, vector = Axles(), True
    magnitude = f"the magnitude of the {FORCE}"
    signed = f"the {{component}}{FORCE}"
    how = "how large a force does the axle exert on {body} {when}?"
    needs = ("mass",)
    immediate = True
    weight = 3.0
    floor, heavy = 0.1, True

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return Σ m (a − g) of all bodies that turn together, in N, (n, 3)."""
        return -ForceOnAxle.evaluate(state, subject)

    def signed_along(self, sense: Sense, mechanism: Mechanism, name: str) -> str:
        """Return *the upward component* or *the rightward component*, so that the phrase fixes the sign."""
        del mechanism, name
        way = "upward" if sense.axis == VERTICAL else "rightward"
        return f"the {way} component of the {FORCE}"
