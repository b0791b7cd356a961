"""Momentum and angular momentum, and their rates of change."""

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.triples import applied, cross, plus
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.kinematics import Acceleration, Velocity
from sim2reason.quantities.rotation import AngularAcceleration, AngularVelocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import is_welded_part
from sim2reason.quantities.subjects.turners import TurningBodies


@quantity
class Momentum(Quantity):
    """The momentum of a body alone, whatever it carries."""

    name, unit, symbol = "momentum", "kg m/s", "p"
    of, vector = Bodies(), True
    magnitude = "the magnitude of the momentum of {body}{ground}"
    signed = "the {component}momentum of {body}{ground}"
    given = True
    needs = ("mass",)
    weight = 0.02  # of one body alone it is seldom more than its speed times its mass
    floor, heavy = 0.1, True
    order = 3

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """P = m v of the centre of mass, (n, 3)."""
        return np.asarray(state.mass(subject))[..., None] * Velocity.evaluate(state, subject)


@quantity
class NetForce(Quantity):
    """The sum of all forces on a body alone; of a part of a rigid body nobody asks for it."""

    name, unit, symbol = "net force", "N", "F"
    of, vector = Bodies(), True
    magnitude = "the magnitude of the net force on {body}"
    signed = "the {component}net force on {body}"
    immediate = True
    needs = ("mass",)
    weight = 0.15  # rather its acceleration, or one of the forces
    floor, heavy = 0.1, True
    order = 4

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body is not welded to others."""
        return not is_welded_part(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """F = m a, (n, 3)."""
        return np.asarray(state.mass(subject))[..., None] * Acceleration.evaluate(state, subject)


class AboutCenter(Quantity):
    """What a body that turns has about its own centre of mass."""

    of, vector = TurningBodies(), True
    needs = ("mass",)
    weight = 0.02  # rather its angular velocity and acceleration
    floor, heavy = 0.01, True

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body has a moment of inertia."""
        return any(mechanism.body[name].inertia)

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body has a moment of inertia and is not part of a larger rigid body."""
        return any(mechanism.body[name].inertia) and not is_welded_part(mechanism, name)


@quantity
class AngularMomentum(AboutCenter):
    """The angular momentum of a body alone about its own centre of mass."""

    name, unit, symbol = "angular momentum", "kg m^2/s", "L"
    magnitude = "the magnitude of the angular momentum of {body} about its centre of mass"
    given = True
    order = 3

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """L = I ω, with the inertia of this body alone, (n, 3)."""
        frame, inertia = state.frames[subject], state.mechanism.body[subject].inertia
        return state.vector(frame.turned(applied(inertia, frame.unturned(frame.turning.velocity))))


@quantity
class Torque(AboutCenter):
    """The sum of the torques of all forces on a body about its own centre of mass."""

    name, unit, symbol = "torque", "N m", "τ"
    magnitude = "the magnitude of the net torque on {body} about its centre of mass"
    immediate = True
    order = 4

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """dL/dt = I α + ω × I ω (Euler), (n, 3)."""
        frame, inertia = state.frames[subject], state.mechanism.body[subject].inertia
        alpha, omega = AngularAcceleration.evaluate(state, subject), AngularVelocity.evaluate(state, subject)
        own = frame.unturned((omega[:, 0], omega[:, 1], omega[:, 2]))
        change = frame.unturned((alpha[:, 0], alpha[:, 1], alpha[:, 2]))
        return state.vector(frame.turned(plus(applied(inertia, change), cross(own, applied(inertia, own)))))
