"""Directions of velocities of bodies that move freely in a plane; only for structured questions, and never drawn."""

from math import degrees

import numpy as np

from sim2reason.dsl.fields import Magnetic
from sim2reason.dsl.mechanism import ZERO, Mechanism
from sim2reason.dsl.state import Array, State
from sim2reason.dsl.vectors import unit
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.kinematics import Acceleration, Velocity
from sim2reason.quantities.subjects.bodies import AXES, Bodies
from sim2reason.quantities.subjects.paths import center_path


@quantity
class SlopeOfVelocity(Quantity):
    """The angle of a projectile's velocity with the horizontal."""

    name, unit, symbol = "angle with the horizontal", "deg", "β"
    of = Bodies()
    drawn_by_recipes = False
    floor = 1.0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """From 0 to 90 degrees, up or down, (n,); 0 at rest."""
        velocity = Velocity.evaluate(state, subject)
        up = -np.array(unit(state.mechanism.gravity))
        rising = velocity @ up
        across = np.linalg.norm(velocity - rising[:, None] * up, axis=1)
        return degrees(1.0) * np.arctan2(np.abs(rising), across)

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of the bodies that move freely in a vertical plane."""
        return tuple(name for name in _free(self, mechanism) if mechanism.gravity != ZERO and _upright(mechanism, name))


@quantity
class TurnOfVelocity(Quantity):
    """The angle between the velocity of a body that moves freely in a plane and its initial velocity."""

    name, unit, symbol = "angle of deflection", "deg", "δ"
    of = Bodies()
    drawn_by_recipes = False
    floor = 1.0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """From 0 to 180 degrees, (n,); 0 for a body that is at rest at the start."""
        velocity = Velocity.evaluate(state, subject)
        own = state.mechanism.body[subject].coordinates
        began = np.sum([coordinate.speed * np.array(coordinate.axis) for coordinate in own], axis=0)
        across = np.linalg.norm(np.cross(began, velocity), axis=1)
        return degrees(1.0) * np.arctan2(across, velocity @ began)

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of the bodies that move freely in a plane."""
        return _free(self, mechanism)


@quantity
class RadiusOfPath(Quantity):
    """The radius of the circle on which a magnetic field alone keeps a body."""

    name, unit, symbol = "radius of the path", "m", "r"
    of = Bodies()
    drawn_by_recipes = False
    floor = 0.1

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """v² / a, (n,)."""
        speed, bend = (np.linalg.norm(found.evaluate(state, subject), axis=1) for found in (Velocity, Acceleration))
        return speed**2 / bend

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of the bodies on which uniform magnetic fields alone act, in a plane."""
        return tuple(name for name in _free(self, mechanism) if _circles(mechanism, name))


def _circles(mechanism: Mechanism, name: str) -> bool:
    acting = [force for force in mechanism.forces if force.body == name]
    falls = mechanism.gravity != ZERO and center_path(mechanism, name).rises
    pulled = any(name in (pull.a, pull.b) for pull in mechanism.attractions) or mechanism.lines or mechanism.faces
    uniform = (
        force.region is None and isinstance(force.law, Magnetic) and force.law.profile.uniform for force in acting
    )
    return bool(acting) and all(uniform) and not falls and not pulled


def _free(quantity: Quantity, mechanism: Mechanism) -> tuple[str, ...]:
    """Return the names of bodies that slide along two axes of the text."""
    names = quantity.of.names(mechanism)
    return tuple(name for name in names if sum(c.label in AXES for c in mechanism.body[name].coordinates) > 1)


def _upright(mechanism: Mechanism, name: str) -> bool:
    """Return whether one of the axes is vertical."""
    return center_path(mechanism, name).rises and any(
        abs(coordinate.axis[2]) > 1.0 - 1e-9 for coordinate in mechanism.body[name].coordinates
    )
