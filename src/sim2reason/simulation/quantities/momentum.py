"""Momenta, centres of mass and moments of inertia."""

import numpy as np

from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.scenes.dsl.vectors import add_triples, apply_tensor, cross, dot, subtract_triples
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.kinematics import Acceleration, AngularAcceleration, AngularVelocity, Velocity
from sim2reason.simulation.quantities.subjects.bodies import (
    Bodies,
    TurningBodies,
    WholeScene,
    ancestor_chain,
    can_move,
    is_welded_part,
    turning_axes,
)


@quantity
class Momentum(Quantity):
    """The momentum of a single body, without the bodies that it carries."""

    name, unit, symbol = "momentum", "kg m/s", "p"
    of, vector = Bodies(), True
    magnitude = "the magnitude of the momentum of {body}{ground}"
    signed = "the {component}momentum of {body}{ground}"
    given = True
    needs = ("mass",)
    weight = 0.02  # of one body it is seldom more than its speed times its mass
    floor, heavy = 0.1, True
    order = 3

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return p = m v of the centre of mass in kg m/s, (n, 3)."""
        return np.asarray(state.mass(subject))[..., None] * Velocity.evaluate(state, subject)


@quantity
class NetForce(Quantity):
    """The sum of all forces on a single body; not asked for parts of a rigid body."""

    name, unit, symbol = "net force", "N", "F"
    of, vector = Bodies(), True
    magnitude = "the magnitude of the net force on {body}"
    signed = "the {component}net force on {body}"
    immediate = True
    needs = ("mass",)
    weight = 0.15  # its acceleration, or one of the forces, is preferred
    floor, heavy = 0.1, True
    order = 4

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body is not welded to others."""
        return not is_welded_part(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return F = m a in N, (n, 3)."""
        return np.asarray(state.mass(subject))[..., None] * Acceleration.evaluate(state, subject)


class CentralQuantity(Quantity):
    """Base class of rotational quantities of a body about its own centre of mass."""

    of, vector = TurningBodies(), True
    needs = ("mass",)
    weight = 0.02  # its angular velocity and acceleration are preferred
    floor, heavy = 0.01, True

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body has a moment of inertia."""
        return any(mechanism.body[name].inertia)

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body has a moment of inertia and is not part of a larger rigid body."""
        return any(mechanism.body[name].inertia) and not is_welded_part(mechanism, name)


@quantity
class AngularMomentum(CentralQuantity):
    """The angular momentum of a single body about its own centre of mass."""

    name, unit, symbol = "angular momentum", "kg m^2/s", "L"
    magnitude = "the magnitude of the angular momentum of {body} about its centre of mass"
    given = True
    order = 3

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return L = I ω with the inertia of this body alone, in kg m²/s, (n, 3)."""
        frame, inertia = state.frames[subject], state.mechanism.body[subject].inertia
        return state.vector(frame.turned(apply_tensor(inertia, frame.to_body_axes(frame.turning.velocity))))


@quantity
class Torque(CentralQuantity):
    """The sum of the torques of all forces on a body about its own centre of mass."""

    name, unit, symbol = "torque", "N m", "τ"
    magnitude = "the magnitude of the net torque on {body} about its centre of mass"
    immediate = True
    order = 4

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return dL/dt = I α + ω × I ω (Euler) in N m, (n, 3)."""
        frame, inertia = state.frames[subject], state.mechanism.body[subject].inertia
        alpha, omega = AngularAcceleration.evaluate(state, subject), AngularVelocity.evaluate(state, subject)
        own = frame.to_body_axes((omega[:, 0], omega[:, 1], omega[:, 2]))
        change = frame.to_body_axes((alpha[:, 0], alpha[:, 1], alpha[:, 2]))
        return state.vector(
            frame.turned(add_triples(apply_tensor(inertia, change), cross(own, apply_tensor(inertia, own))))
        )


@quantity
class BodyMass(Quantity):
    """The mass of a body; asked for rockets, and given for all other bodies."""

    name, unit, symbol = "mass", "kg", "m"
    of = Bodies()
    magnitude = "the mass of {body}"
    needs = ("mass",)
    given = True
    weight = 0.5
    floor, heavy = 0.1, True

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the remaining mass in kg, (n,)."""
        return np.zeros(len(state.times)) + state.mass(subject)

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the mass changes."""
        return any(burn.body == name for burn in mechanism.burns)


@quantity
class MomentOfInertia(CentralQuantity):
    """The moment of inertia of a body about its axis of rotation through its centre of mass."""

    name, unit, symbol = "moment of inertia", "kg m^2", "I"
    vector = False
    magnitude = (
        "the moment of inertia of {body} about the line through its centre of mass parallel to its axis of rotation"
    )
    timeless = immediate = True
    weight = 0.2
    least = 1e-4

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return n·I n in kg m², (n,), with the axis n of the innermost hinge."""
        _, axis = turning_axes(state.mechanism, subject)[0]
        moment = dot(axis, apply_tensor(state.mechanism.body[subject].inertia, axis))
        return np.full(len(state.times), moment)


class InertiaTensor(CentralQuantity):
    """Base class of the components of the inertia tensor of a body about its centre of mass, in the world axes."""

    @staticmethod
    def columns(state: State, subject: str) -> list[Array]:
        """Return R I Rᵀ, column by column, in kg m², each (n, 3)."""
        frame, inertia = state.frames[subject], state.mechanism.body[subject].inertia
        axes = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
        return [state.vector(frame.turned(apply_tensor(inertia, frame.to_body_axes(axis)))) for axis in axes]


@quantity
class InertiaDiagonal(InertiaTensor):
    """The diagonal of the inertia tensor; recorded, not asked."""

    name, unit, symbol = "inertia tensor, diagonal", "kg m^2", "I"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return (Ixx, Iyy, Izz) in kg m², (n, 3)."""
        x, y, z = InertiaTensor.columns(state, subject)
        return np.stack([x[:, 0], y[:, 1], z[:, 2]], axis=1)


@quantity
class InertiaOffDiagonal(InertiaTensor):
    """The products of inertia (off-diagonal components); recorded, not asked."""

    name, unit, symbol = "inertia tensor, off the diagonal", "kg m^2", "I"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return (Ixy, Ixz, Iyz) in kg m², (n, 3)."""
        x, y, _ = InertiaTensor.columns(state, subject)
        return np.stack([x[:, 1], x[:, 2], y[:, 2]], axis=1)


@quantity
class AxleDistance(Quantity):
    """The distance of a body's centre of mass from its fixed axle; in structured questions only."""

    name, unit, symbol = "distance from the axle", "m", "d"
    of = Bodies()
    drawn_by_recipes = False
    floor = 0.1
    timeless = True

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the distance of the centre of mass from the axis of the hinge in m, (n,)."""
        mechanism = state.mechanism
        _, axis = turning_axes(mechanism, subject)[0]
        turning = next(
            body for body in ancestor_chain(mechanism, subject) if any(c.kind == "hinge" for c in body.coordinates)
        )
        arm = state.vector(
            subtract_triples(state.frames.center(subject).place, state.frames[turning.name].point(ZERO).place)
        )
        return np.linalg.norm(np.cross(arm, np.array(axis)), axis=1)

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body has a mass and turns about one fixed hinge."""
        return mechanism.body[name].mass > 0.0 and _is_on_axle(mechanism, name)


@quantity
class InertiaAboutAxle(CentralQuantity):
    """The moment of inertia of a body about its fixed axle; for structured questions only, not drawn by recipes."""

    name, unit, symbol = "moment of inertia about the axle", "kg m^2", "I"
    vector = False
    drawn_by_recipes = False

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return n·I n + m d² in kg m², with the distance d of the centre of mass from the axis of the hinge, (n,)."""
        mechanism = state.mechanism
        _, axis = turning_axes(mechanism, subject)[0]
        moment = dot(axis, apply_tensor(mechanism.body[subject].inertia, axis))
        return moment + mechanism.body[subject].mass * AxleDistance.evaluate(state, subject) ** 2

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body has a mass and turns about one fixed hinge."""
        return mechanism.body[name].mass > 0.0 and _is_on_axle(mechanism, name)


def _is_on_axle(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body can turn about one hinge and cannot move otherwise."""
    kinds = [c.kind for body in ancestor_chain(mechanism, name) for c in body.coordinates]
    return kinds == ["hinge"]


@quantity
class InertiaAboutAxis(InertiaAboutAxle):
    """The moment of inertia of a round body on a face about its axis, on which its centre of mass need not lie.

    It is used in structured questions only, and never drawn by recipes.
    """

    name = "moment of inertia about the axis"

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body lies on a face and has a hinge of its own."""
        return name in mechanism.contacts and any(c.kind == "hinge" for c in mechanism.body[name].coordinates)


@quantity
class MassCenterVelocity(Quantity):
    """The velocity of the centre of mass of all bodies, if there are several and all can move."""

    name, unit, symbol = "velocity of the centre of mass", "m/s", "v"
    of, vector = WholeScene(), True
    drawn_by_recipes = False
    needs = ("mass",)
    floor = 0.1

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether there are several bodies with a mass and all of them can move."""
        del name
        heavy = [body.name for body in mechanism.bodies if body.mass > 0.0]
        return len(heavy) > 1 and all(can_move(mechanism, each) for each in heavy)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return Σ m v / Σ m in m/s, (n, 3)."""
        del subject
        mass, momentum = np.zeros((len(state.times), 1)), np.zeros((len(state.times), 3))
        for body in state.mechanism.bodies:
            if body.mass > 0.0:
                mass = mass + np.asarray(state.mass(body.name)).reshape(-1, 1)
                momentum = momentum + Momentum.evaluate(state, body.name)
        return momentum / mass
