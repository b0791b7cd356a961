"""Where bodies are and how they move: of their centres of mass, in room coordinates."""

from sim2reason.dsl.kinematics import carried, slides_of
from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.subjects.bodies import Bodies


@quantity
class Displacement(Quantity):
    """The displacement of the centre of mass from where it was at the start."""

    name, unit, symbol = "displacement", "m", "s"
    of, vector = Bodies(), True
    magnitude = "the distance of {body} from its starting point"
    signed = "the {component}displacement of {body} from its starting point"
    how = "how far is {body} from its starting point{ground} {when}?"
    grounded = True
    weight = 2.0
    floor = 0.1
    panel, order = "displacement", 0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Σ axis·q over the slides that carry the body, (n, 3)."""
        return carried(slides_of(state.mechanism, subject), state.q)


@quantity
class Velocity(Quantity):
    """The velocity of the centre of mass."""

    name, unit, symbol = "velocity", "m/s", "v"
    of, vector = Bodies(), True
    magnitude = "the speed of {body}"
    signed = "the {component}velocity of {body}"
    how = "how fast is {body} moving{ground} {when}?"
    grounded = given = True
    weight = 3.0
    floor, least = 0.1, 1e-2
    panel, order = "velocity", 1

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Σ axis·v over the slides that carry the body, (n, 3)."""
        return carried(slides_of(state.mechanism, subject), state.v)


@quantity
class Acceleration(Quantity):
    """The acceleration of the centre of mass."""

    name, unit, symbol = "acceleration", "m/s^2", "a"
    of, vector = Bodies(), True
    magnitude = "the magnitude of the acceleration of {body}"
    signed = "the {component}acceleration of {body}"
    grounded = immediate = True
    weight = 2.0
    floor, least = 1.0, 1e-2
    panel, order = "acceleration", 2

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Σ axis·a over the slides that carry the body, (n, 3)."""
        return carried(slides_of(state.mechanism, subject), state.a)
