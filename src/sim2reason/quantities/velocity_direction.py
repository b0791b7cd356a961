"""Directions of velocities of bodies that move freely in a plane; only for structured questions, and never drawn."""

from math import degrees

import numpy as np

from sim2reason.dsl.fields import Magnetic
from sim2reason.dsl.mechanism import ZERO, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.vectors import unit
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.kinematics import CurvatureRadius, Velocity
from sim2reason.quantities.subjects.bodies import Bodies, moves_in_plane
from sim2reason.quantities.subjects.paths import center_path


class OfFreeBody(Quantity):
    """Base class of quantities of the path of a body that moves freely in a plane."""

    of = Bodies()
    drawn_by_recipes = False

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body moves freely in a plane."""
        return moves_in_plane(mechanism, name)


@quantity
class SlopeOfVelocity(OfFreeBody):
    """The angle of a projectile's velocity with the horizontal."""

    name, unit, symbol = "angle with the horizontal", "deg", "β"
    floor = 1.0

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body moves freely in a vertical plane under uniform gravity."""
        return super().fits(mechanism, name) and mechanism.gravity != ZERO and _upright(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """From 0 to 90 degrees, up or down, (n,); 0 at rest."""
        velocity = Velocity.evaluate(state, subject)
        up = -np.array(unit(state.mechanism.gravity))
        rising = velocity @ up
        across = np.linalg.norm(velocity - rising[:, None] * up, axis=1)
        return degrees(1.0) * np.arctan2(np.abs(rising), across)


@quantity
class TurnOfVelocity(OfFreeBody):
    """The angle between the velocity of a body and its initial velocity."""

    name, unit, symbol = "angle of deflection", "deg", "δ"
    floor = 1.0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """From 0 to 180 degrees, (n,); 0 for a body that is at rest at the start."""
        velocity = Velocity.evaluate(state, subject)
        own = state.mechanism.body[subject].coordinates
        began = np.sum([coordinate.speed * np.array(coordinate.axis) for coordinate in own], axis=0)
        across = np.linalg.norm(np.cross(began, velocity), axis=1)
        return degrees(1.0) * np.arctan2(across, velocity @ began)


@quantity
class RadiusOfPath(OfFreeBody):
    """The radius of the circle on which a magnetic field alone keeps a body."""

    name, unit, symbol = "radius of the path", "m", "r"
    floor = 0.1

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body moves freely in a plane, and uniform magnetic fields alone act on it."""
        return super().fits(mechanism, name) and _circles(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the radius of curvature in m, (n,), which is the same everywhere on a circle."""
        return CurvatureRadius.evaluate(state, subject)


def _circles(mechanism: Mechanism, name: str) -> bool:
    acting = [force for force in mechanism.forces if force.body == name]
    falls = mechanism.gravity != ZERO and center_path(mechanism, name).rises
    pulled = any(name in (pull.a, pull.b) for pull in mechanism.attractions) or mechanism.lines or mechanism.faces
    uniform = (
        force.region is None and isinstance(force.law, Magnetic) and force.law.profile.uniform for force in acting
    )
    return bool(acting) and all(uniform) and not falls and not pulled


def _upright(mechanism: Mechanism, name: str) -> bool:
    """Return whether one of the axes is vertical."""
    return center_path(mechanism, name).rises and any(
        abs(coordinate.axis[2]) > 1.0 - 1e-9 for coordinate in mechanism.body[name].coordinates
    )
