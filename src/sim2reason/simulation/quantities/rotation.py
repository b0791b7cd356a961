"""Angles, angular velocities and angular accelerations of bodies."""

from math import degrees

import numpy as np

from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import inner, plus, times
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.subjects.bodies import TurningBodies
from sim2reason.simulation.quantities.subjects.paths import parallel, turning_axes


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
            total = plus(total, times(state.a[:, number], axis))
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
        return degrees(1.0) * _turned(state, subject)


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
        return _turned(state, subject)


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
        return _turned(state, subject) / (2.0 * np.pi)


def _about_one_axis(mechanism: Mechanism, name: str) -> bool:
    axes = [axis for _, axis in turning_axes(mechanism, name)]
    return all(parallel(axis, axes[0]) for axis in axes)


def _rolls(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body can roll on a face: its slip there depends on the angle of one of its hinges."""
    hinges = {hinge for hinge, _ in turning_axes(mechanism, name)}
    return any(hinge in hinges for face in mechanism.faces for hinge, _ in face.slip if not face.turning)


def _turned(state: State, subject: str) -> Array:
    """Return the angle of rotation since the start in rad, (n,)."""
    mechanism = state.mechanism
    axes = turning_axes(mechanism, subject)
    total = np.zeros(len(state.times))
    for name, axis in axes:
        total = total + inner(axis, axes[0][1]) * state.q[:, mechanism.number[name]]
    return total
