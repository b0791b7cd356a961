"""Positions, velocities and accelerations of centres of mass, and angular quantities of bodies."""

from math import degrees

import numpy as np

from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import add_triples, inner, scale_triple, subtract_triples
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.subjects import Sense
from sim2reason.simulation.quantities.subjects.bodies import (
    DIRECTION_TOL,
    HORIZONTAL,
    VERTICAL,
    Bodies,
    TurningBodies,
    center_path,
    parallel,
    turning_axes,
)

RANGE, SLANTED = 1.5, 0.15  # relative frequencies of the range of a projectile, and of its slanted distance
SWUNG_FREQUENCY = 0.3  # relative frequency of the acceleration of a point on a swinging body
STRAIGHT_PATH_RTOL = 1e-9  # fraction of the product of speed and acceleration: below, the path counts as straight


@quantity
class Displacement(Quantity):
    """The displacement of the centre of mass from its initial position."""

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
        """Return the phrases of *the height above the ground* for a rocket that starts from the ground."""
        if not _launched(mechanism, name):
            return super().size_phrases(mechanism, name)
        size, high = "the height of {body} above the ground", "how high above the ground"
        return size, f"{high} is {{body}} {{when}}?", f"{high} {{body}} is", "{body} is {value} above the ground"

    def signed_along(self, sense: Sense, mechanism: Mechanism, name: str) -> str:
        """Return the template of *the horizontal displacement* or *the vertical displacement* in a vertical plane."""
        which = _direction(sense, mechanism, name)
        return self.signed.replace("{component}", f"{which} ") if which else self.signed

    def share(self, sense: Sense | None, mechanism: Mechanism, name: str) -> float:
        """Return a larger frequency for the horizontal range of a projectile than for its slanted distance."""
        thrown = _falls_in_a_plane(mechanism, name)
        if sense is None:
            return SLANTED if thrown else 1.0
        return RANGE if _direction(sense, mechanism, name) == HORIZONTAL else sense.share

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the displacement of the centre of mass in m, (n, 3)."""
        return state.vector(subtract_triples(state.frames.center(subject).place, state.began.center(subject).place))


def _falls_in_a_plane(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body can move both up and sideways in a uniform gravitational field."""
    ways = [direction[2] for direction in center_path(mechanism, name).ways]
    upright = any(abs(direction) > 1.0 - DIRECTION_TOL for direction in ways) and any(
        abs(direction) < DIRECTION_TOL for direction in ways
    )
    return upright and mechanism.gravity != ZERO


def _direction(sense: Sense, mechanism: Mechanism, name: str) -> str:
    """Return *horizontal* or *vertical* for an axis of a vertical plane with gravity, else an empty string."""
    along = abs(sense.vector[2])
    if not sense.axis or not _falls_in_a_plane(mechanism, name) or DIRECTION_TOL < along < 1.0 - DIRECTION_TOL:
        return ""
    return HORIZONTAL if along <= DIRECTION_TOL else VERTICAL


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
        """Return J q̇ of the centre of mass in m/s, (n, 3)."""
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
        """Return a smaller frequency for a part of a swinging body, as its angular acceleration is more informative."""
        usual = super().share(sense, mechanism, name)
        return SWUNG_FREQUENCY * usual if center_path(mechanism, name).swings else usual

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return J q̈ + J̇ q̇ of the centre of mass in m/s², (n, 3)."""
        point = state.frames.center(subject)
        total = point.bias
        for number, jacobian_column in point.gradient.items():
            total = add_triples(total, scale_triple(state.a[:, number], jacobian_column))
        return state.vector(total)


@quantity
class CurvatureRadius(Quantity):
    """The radius of curvature of the path; for a circular orbit in a magnetic field, the radius of the circle."""

    name, unit, symbol = "radius of curvature", "m", "R"
    of = Bodies()
    magnitude = "the radius of curvature of the path of {body}{ground}"
    center = True
    drawn_by_recipes = False
    floor = 0.1
    order = 3

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the path is curved."""
        return not center_path(mechanism, name).straight

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return |v|³/|v × a| in m, (n,); NaN if the path is straight there or the body is at rest."""
        velocity, acceleration = Velocity.evaluate(state, subject), Acceleration.evaluate(state, subject)
        speed, turning = np.linalg.norm(velocity, axis=1), np.linalg.norm(np.cross(velocity, acceleration), axis=1)
        bends = turning > STRAIGHT_PATH_RTOL * speed * np.linalg.norm(acceleration, axis=1)
        return np.where(bends, speed**3 / np.where(bends, turning, 1.0), np.nan)


@quantity
class CenterOffset(Quantity):
    """The position of the centre of mass relative to the origin of the body's frame; recorded, not asked."""

    name, unit, symbol = "centre of mass offset", "m", "c"
    of, vector = Bodies(), True
    floor = 0.1

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the bodies whose frame has its origin elsewhere than the centre of mass."""
        return tuple(body.name for body in mechanism.bodies if body.center != ZERO)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return R c in m, (n, 3), with the rotation R of the body and the centre of mass c in its frame."""
        return state.vector(state.frames[subject].turned(state.mechanism.body[subject].center))


def _launched(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body burns fuel and starts at the lower end of its travel, on the ground."""
    burns = any(burn.body == name for burn in mechanism.burns)
    return burns and [coordinate.lower for coordinate in mechanism.body[name].coordinates] == [0.0]


@quantity
class AngularVelocity(Quantity):
    """The angular velocity of a body in the world frame."""

    name, unit, symbol = "angular velocity", "rad/s", "ω"
    of, vector = TurningBodies(), True
    magnitude = "the magnitude of the angular velocity of {body}"
    how = "with what angular speed is {body} turning {when}?"
    given = True
    weight = 2.0
    floor, least = 0.1, 1e-2
    panel, order = "angular velocity", 1

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the sum of the rates of all hinges, each about its present axis, (n, 3)."""
        return state.vector(state.frames[subject].turning.velocity)


@quantity
class AngularAcceleration(Quantity):
    """The angular acceleration of a body in the world frame."""

    name, unit, symbol = "angular acceleration", "rad/s^2", "α"
    of, vector = TurningBodies(), True
    magnitude = "the magnitude of the angular acceleration of {body}"
    immediate = True
    floor, least = 1.0, 1e-2
    panel, order = "angular acceleration", 2

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the rate of change of the angular velocity in rad/s², (n, 3), including the motion of the axes."""
        turning = state.frames[subject].turning
        total = turning.bias
        for number, axis in turning.gradient.items():
            total = add_triples(total, scale_triple(state.a[:, number], axis))
        return state.vector(total)


class Angle(Quantity):
    """Base class of angles of a body that rotates about parallel axes, so that the angles add up."""

    of = TurningBodies()

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether all axes of rotation are parallel and the body has the quantity."""
        return name in self.subjects(mechanism)

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether all axes about which the body turns are parallel."""
        return _about_one_axis(mechanism, name)


@quantity
class AngleTurned(Angle):
    """The angle of rotation since the start, in degrees, positive about the axis of the body's innermost hinge."""

    name, unit, symbol = "angle turned", "deg", "φ"
    magnitude = "the angle through which {body} has turned from its starting position"
    how = "through what angle has {body} turned from its starting position {when}?"
    weight = 2.0
    floor, least = 1.0, 0.1
    from_start = True
    panel, order = "angle turned", 0

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body swings rather than rolls."""
        return super().fits(mechanism, name) and not _rolls(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the sum of the angles of all hinges in degrees, (n,)."""
        return degrees(1.0) * _angle_turned(state, subject)


@quantity
class AngleRolled(Angle):
    """The angle of rotation since the start, in radians, of a rolling or slipping body; it may exceed a full turn.

    Phrases call it the net angle if the rotation may reverse.
    """

    name, unit, symbol = "angle rolled", "rad", "φ"
    magnitude = "the {net}angle through which {body} has turned since the start"
    over = "the {net}angle through which {body} turns"
    floor, least = 0.1, 1e-2
    from_start = True
    panel, order = "angle turned", 0

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body rolls."""
        return super().fits(mechanism, name) and _rolls(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the sum of the angles of all hinges in rad, (n,)."""
        return _angle_turned(state, subject)


@quantity
class Revolutions(Angle):
    """The number of revolutions since the start, whole or not, of a body that rotates about one axis."""

    name, unit, symbol = "revolutions made", "", "N"
    drawn_by_recipes = False
    floor, least = 0.1, 1e-3
    from_start = True

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the angle of rotation divided by 2π, (n,)."""
        return _angle_turned(state, subject) / (2.0 * np.pi)


def _about_one_axis(mechanism: Mechanism, name: str) -> bool:
    axes = [axis for _, axis in turning_axes(mechanism, name)]
    return all(parallel(axis, axes[0]) for axis in axes)


def _rolls(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body can roll on a face: its slip there depends on the angle of one of its hinges."""
    hinges = {hinge for hinge, _ in turning_axes(mechanism, name)}
    return any(hinge in hinges for face in mechanism.faces for hinge, _ in face.slip if not face.turning)


def _angle_turned(state: State, subject: str) -> Array:
    """Return the angle of rotation since the start in rad, (n,)."""
    mechanism = state.mechanism
    axes = turning_axes(mechanism, subject)
    total = np.zeros(len(state.times))
    for name, axis in axes:
        total = total + inner(axis, axes[0][1]) * state.q[:, mechanism.number[name]]
    return total
