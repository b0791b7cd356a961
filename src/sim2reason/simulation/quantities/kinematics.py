"""Where bodies are and how they move: of their centres of mass, in room coordinates."""

import numpy as np

from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import minus, plus, times
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.quantities.subjects.bodies import HORIZONTAL, VERTICAL, Bodies
from sim2reason.simulation.quantities.subjects.paths import EVEN, center_path

RANGE, SLANTED = 1.5, 0.15  # shares of the horizontal displacement of what is thrown, and of its distance
SWUNG = 0.3  # share of the acceleration of a point of what swings
STRAIGHT = 1e-9  # of the product of speed and acceleration: with less between them, a path does not bend


@quantity
class Displacement(Quantity):
    """The displacement of the centre of mass from where it was at the start."""

    name, unit, symbol = "displacement", "m", "s"
    of, vector = Bodies(), True
    magnitude = "the distance between {body} and its starting point{ground}"
    signed = "the {component}displacement of {body} from its starting point{ground}"
    how = "how far is {body} from its starting point{ground} {when}?"
    indirect = "how far {body} is from its starting point{ground}"
    states = "{body} is {value} from its starting point{ground}"
    center = from_start = True
    weight = 1.2
    floor = 0.1
    panel, order = "displacement", 0

    def size_phrases(self, mechanism: Mechanism, name: str) -> tuple[str, str, str, str]:
        """Return *the height above the ground* for a rocket that starts from the ground."""
        if not _launched(mechanism, name):
            return super().size_phrases(mechanism, name)
        size, high = "the height of {body} above the ground", "how high above the ground"
        return size, f"{high} is {{body}} {{when}}?", f"{high} {{body}} is", "{body} is {value} above the ground"

    def signed_along(self, sense: Sense, mechanism: Mechanism, name: str) -> str:
        """Return *the horizontal displacement* or *the vertical displacement* in a vertical plane with gravity."""
        which = _direction(sense, mechanism, name)
        return self.signed.replace("{component}", f"{which} ") if which else self.signed

    def share(self, sense: Sense | None, mechanism: Mechanism, name: str) -> float:
        """Return more for the horizontal range of what is thrown than for the distance along a slanted line."""
        thrown = _falls_in_a_plane(mechanism, name)
        if sense is None:
            return SLANTED if thrown else 1.0
        return RANGE if _direction(sense, mechanism, name) == HORIZONTAL else sense.share

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Of the centre of mass, not of the frame, (n, 3)."""
        return state.vector(minus(state.frames.center(subject).place, state.began.center(subject).place))


def _falls_in_a_plane(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body can move both up and sideways in a uniform gravitational field."""
    ways = [way[2] for way in center_path(mechanism, name).ways]
    upright = any(abs(way) > 1.0 - EVEN for way in ways) and any(abs(way) < EVEN for way in ways)
    return upright and mechanism.gravity != ZERO


def _direction(sense: Sense, mechanism: Mechanism, name: str) -> str:
    """Return *horizontal* or *vertical* for an axis of the text in a vertical plane with gravity, else nothing."""
    along = abs(sense.vector[2])
    if not sense.axis or not _falls_in_a_plane(mechanism, name) or EVEN < along < 1.0 - EVEN:
        return ""
    return HORIZONTAL if along <= EVEN else VERTICAL


@quantity
class Velocity(Quantity):
    """The velocity of the centre of mass."""

    name, unit, symbol = "velocity", "m/s", "v"
    of, vector = Bodies(), True
    magnitude = "the speed of {body}{ground}"
    signed = "the {component}velocity of {body}{ground}"
    how = "how fast is {body} moving{ground} {when}?"
    indirect = "how fast {body} is moving{ground}"
    states = "{body} is moving at {value}{ground}"
    center = given = True
    weight = 2.0
    floor, least = 0.1, 1e-2
    panel, order = "velocity", 1

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """J q̇ of the centre of mass, (n, 3)."""
        return state.vector(state.frames.center(subject).velocity)


@quantity
class Acceleration(Quantity):
    """The acceleration of the centre of mass."""

    name, unit, symbol = "acceleration", "m/s^2", "a"
    of, vector = Bodies(), True
    magnitude = "the magnitude of the acceleration of {body}{ground}"
    signed = "the {component}acceleration of {body}{ground}"
    center = immediate = True
    weight = 2.0
    floor, least = 1.0, 1e-2
    panel, order = "acceleration", 2

    def share(self, sense: Sense | None, mechanism: Mechanism, name: str) -> float:
        """Return less for a part of what swings, whose angular acceleration and axle tell more."""
        usual = super().share(sense, mechanism, name)
        return SWUNG * usual if center_path(mechanism, name).swings else usual

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """J q̈ of the centre of mass, and what its path and its carriers bend, (n, 3)."""
        point = state.frames.center(subject)
        total = point.bias
        for number, way in point.gradient.items():
            total = plus(total, times(state.a[:, number], way))
        return state.vector(total)


@quantity
class CurvatureRadius(Quantity):
    """The radius of curvature of the path, that of the circle itself where a body goes round in a magnetic field."""

    name, unit, symbol = "radius of curvature", "m", "R"
    of = Bodies()
    magnitude = "the radius of curvature of the path of {body}{ground}"
    center = True
    drawn_by_recipes = False
    floor = 0.1
    order = 3

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the path is no straight line."""
        return not center_path(mechanism, name).straight

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """|v|³/|v × a| in m, (n,); NaN where the path does not bend, or the body is at rest."""
        velocity, acceleration = Velocity.evaluate(state, subject), Acceleration.evaluate(state, subject)
        speed, turning = np.linalg.norm(velocity, axis=1), np.linalg.norm(np.cross(velocity, acceleration), axis=1)
        bends = turning > STRAIGHT * speed * np.linalg.norm(acceleration, axis=1)
        return np.where(bends, speed**3 / np.where(bends, turning, 1.0), np.nan)


@quantity
class CenterOffset(Quantity):
    """Where the centre of mass lies from the origin of the body's frame, such as its axle; recorded, not asked."""

    name, unit, symbol = "centre of mass offset", "m", "c"
    of, vector = Bodies(), True
    floor = 0.1

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Bodies whose frame stands elsewhere."""
        return tuple(body.name for body in mechanism.bodies if body.center != ZERO)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """R c, (n, 3)."""
        return state.vector(state.frames[subject].turned(state.mechanism.body[subject].center))


def _launched(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body burns fuel and starts at the lower end of its way, on the ground."""
    burns = any(burn.body == name for burn in mechanism.burns)
    return burns and [coordinate.lower for coordinate in mechanism.body[name].coordinates] == [0.0]
