"""Mass, and how it is spread."""

import numpy as np

from sim2reason.dsl.mechanism import ZERO, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.triples import applied, minus, product
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.momentum import AboutCenter
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import chain, turning_axes


@quantity
class BodyMass(Quantity):
    """The mass of a body; it is asked of what burns, and given of all else."""

    name, unit, symbol = "mass", "kg", "m"
    of = Bodies()
    magnitude = "the mass of {body}"
    needs = ("mass",)
    given = True
    weight = 0.5
    floor, heavy = 0.1, True

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """What is left, (n,)."""
        return np.zeros(len(state.times)) + state.mass(subject)

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Whether it changes."""
        return any(burn.body == name for burn in mechanism.burns)


@quantity
class MomentOfInertia(AboutCenter):
    """The moment of inertia of a body about the line through its centre of mass that it turns about."""

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
        """n·I n of the innermost hinge that turns the body, (n,)."""
        _, axis = turning_axes(state.mechanism, subject)[0]
        held = product(axis, applied(state.mechanism.body[subject].inertia, axis))
        return np.full(len(state.times), held)


class InertiaTensor(AboutCenter):
    """Parts of the inertia tensor of a body about its centre of mass, along the axes of the room."""

    @staticmethod
    def columns(state: State, subject: str) -> list[Array]:
        """R I Rᵀ, column by column, each (n, 3)."""
        frame, inertia = state.frames[subject], state.mechanism.body[subject].inertia
        axes = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
        return [state.vector(frame.turned(applied(inertia, frame.unturned(axis)))) for axis in axes]


@quantity
class InertiaDiagonal(InertiaTensor):
    """Its diagonal; recorded, not asked."""

    name, unit, symbol = "inertia tensor, diagonal", "kg m^2", "I"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """(Ixx, Iyy, Izz), (n, 3)."""
        x, y, z = InertiaTensor.columns(state, subject)
        return np.stack([x[:, 0], y[:, 1], z[:, 2]], axis=1)


@quantity
class InertiaOffDiagonal(InertiaTensor):
    """What is beside its diagonal; recorded, not asked."""

    name, unit, symbol = "inertia tensor, off the diagonal", "kg m^2", "I"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """(Ixy, Ixz, Iyz), (n, 3)."""
        x, y, _ = InertiaTensor.columns(state, subject)
        return np.stack([x[:, 1], x[:, 2], y[:, 2]], axis=1)


@quantity
class AxleDistance(Quantity):
    """The distance of a body's centre of mass from the axle that it turns about; in structured questions only."""

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
        turning = next(body for body in chain(mechanism, subject) if any(c.kind == "hinge" for c in body.coordinates))
        arm = state.vector(minus(state.frames.center(subject).place, state.frames[turning.name].point(ZERO).place))
        return np.linalg.norm(np.cross(arm, np.array(axis)), axis=1)

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body has a mass and turns about one fixed hinge."""
        return mechanism.body[name].mass > 0.0 and _on_axle(mechanism, name)


@quantity
class InertiaAboutAxle(AboutCenter):
    """The moment of inertia of a body about the axle that it turns about; in structured questions only, never drawn."""

    name, unit, symbol = "moment of inertia about the axle", "kg m^2", "I"
    vector = False
    drawn_by_recipes = False

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return n·I n + m d² in kg m², with the distance d of the centre of mass from the axis of the hinge, (n,)."""
        mechanism = state.mechanism
        _, axis = turning_axes(mechanism, subject)[0]
        held = product(axis, applied(mechanism.body[subject].inertia, axis))
        return held + mechanism.body[subject].mass * AxleDistance.evaluate(state, subject) ** 2

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body has a mass and turns about one fixed hinge."""
        return mechanism.body[name].mass > 0.0 and _on_axle(mechanism, name)


def _on_axle(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body can turn about one hinge and cannot move otherwise."""
    kinds = [c.kind for body in chain(mechanism, name) for c in body.coordinates]
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
