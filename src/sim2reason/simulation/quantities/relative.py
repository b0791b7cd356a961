"""Quantities of one body relative to another: distances, velocities, and the shape of an orbit."""

from itertools import permutations
from math import degrees

import numpy as np

from sim2reason.scenes.dsl.fields import Magnetic
from sim2reason.scenes.dsl.mechanism import ZERO, Attraction, Mechanism
from sim2reason.scenes.dsl.state import Array, State, row_lengths
from sim2reason.scenes.dsl.vectors import dot, subtract_triples, unit
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.kinematics import CurvatureRadius, Velocity
from sim2reason.simulation.quantities.subjects.bodies import (
    Bodies,
    can_move,
    center_path,
    moves_in_plane,
    moves_on_slider,
)
from sim2reason.simulation.quantities.subjects.interactions import PAIR_SEPARATOR, Pairs, RelativeBodies, members


@quantity
class DistanceBetween(Quantity):
    """The distance between two centres of mass."""

    name, unit, symbol = "distance", "m", "d"
    of = Pairs()
    magnitude = "the distance between {pair}"
    how = "how far apart are {pair} {when}?"
    indirect = "how far apart {pair} are"
    given = center = True
    floor = 0.1
    panel, order = "distance", 0

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of all pairs, then of both orders of any other two bodies that move freely in a plane."""
        free = [body.name for body in mechanism.bodies if moves_in_plane(mechanism, body.name)]
        return tuple(
            dict.fromkeys((*self.of.names(mechanism), *(PAIR_SEPARATOR.join(two) for two in permutations(free, 2))))
        )

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return |r − r′| in m, (n,)."""
        a, b = members(subject)
        separation = subtract_triples(state.frames.center(a).place, state.frames.center(b).place)
        return np.sqrt(dot(separation, separation)) + 0.0 * state.times


@quantity
class RelativeSpeed(Quantity):
    """The speed of two bodies relative to each other."""

    name, unit, symbol = "relative speed", "m/s", "w"
    of = Pairs()
    magnitude = "the relative speed of {pair}"
    given = True
    weight = 0.6
    floor, least = 0.1, 1e-2
    order = 1

    def present(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether both bodies move; otherwise their relative speed is the speed of the moving one."""
        return all(can_move(mechanism, body) for body in members(name))

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return |v − v′| in m/s, (n,)."""
        a, b = members(subject)
        return row_lengths(Velocity.evaluate(state, a) - Velocity.evaluate(state, b))


@quantity
class RelativeVelocity(Quantity):
    """The velocity of one body's centre of mass relative to another's; not drawn by recipes."""

    name, unit, symbol = "relative velocity", "m/s", "u"
    of, vector = RelativeBodies(), True
    given = True
    drawn_by_recipes = False
    floor, least = 0.1, 1e-2
    order = 2

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return v − v′ in m/s, (n, 3)."""
        a, b = members(subject)
        return Velocity.evaluate(state, a) - Velocity.evaluate(state, b)


class CarriedBodyQuantity(Quantity):
    """Base class of quantities of a body that slides along one line on a body that moves without turning."""

    of = Bodies()
    drawn_by_recipes = False
    floor = 0.1

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body slides along one line on a body that moves without turning."""
        return moves_on_slider(mechanism, name) and _slides(mechanism, name)


@quantity
class RiderDisplacement(CarriedBodyQuantity):
    """The displacement of a body relative to the body that carries it."""

    name, unit, symbol = "displacement relative to its carrier", "m", "s"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the coordinate of the body on its carrier in m, zero at the start, (n,)."""
        return _own(state.q, state, subject)


@quantity
class RiderVelocity(CarriedBodyQuantity):
    """The velocity of a body relative to the body that carries it."""

    name, unit, symbol = "speed relative to its carrier", "m/s", "v"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the rate of the coordinate of the body on its carrier in m/s, (n,)."""
        return _own(state.v, state, subject)


@quantity
class RiderAcceleration(CarriedBodyQuantity):
    """The acceleration of a body relative to the body that carries it."""

    name, unit, symbol = "acceleration relative to its carrier", "m/s^2", "a"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the second derivative of the coordinate of the body on its carrier in m/s², (n,)."""
        return _own(state.a, state, subject)


def _own(values: Array, state: State, name: str) -> Array:
    """Return the column of a body's only coordinate, (n,), in the values of all coordinates, (n, coordinates)."""
    mechanism = state.mechanism
    return np.asarray(values[:, mechanism.number[mechanism.body[name].coordinates[0].name]])


def _slides(mechanism: Mechanism, name: str) -> bool:
    carrier = mechanism.body[name].parent
    kinds = [c.kind for part in (name, carrier) if part is not None for c in mechanism.body[part].coordinates]
    return [c.kind for c in mechanism.body[name].coordinates] == ["slide"] and set(kinds) == {"slide"}


class FreeBodyQuantity(Quantity):
    """Base class of quantities of the path of a body that moves freely in a plane."""

    of = Bodies()
    drawn_by_recipes = False

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body moves freely in a plane."""
        return moves_in_plane(mechanism, name)


@quantity
class SlopeOfVelocity(FreeBodyQuantity):
    """The angle of a projectile's velocity with the horizontal."""

    name, unit, symbol = "angle with the horizontal", "deg", "β"
    floor = 1.0

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body moves freely in a vertical plane under uniform gravity."""
        return super().fits(mechanism, name) and mechanism.gravity != ZERO and _upright(mechanism, name)

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the angle above or below the horizontal in degrees, 0 to 90, (n,); 0 at rest."""
        velocity = Velocity.evaluate(state, subject)
        up = -np.array(unit(state.mechanism.gravity))
        rising = velocity @ up
        across = np.linalg.norm(velocity - rising[:, None] * up, axis=1)
        return degrees(1.0) * np.arctan2(np.abs(rising), across)


@quantity
class TurnOfVelocity(FreeBodyQuantity):
    """The angle between the velocity of a body and its initial velocity."""

    name, unit, symbol = "angle of deflection", "deg", "δ"
    floor = 1.0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return the angle in degrees, 0 to 180, (n,); 0 for a body initially at rest."""
        velocity = Velocity.evaluate(state, subject)
        own = state.mechanism.body[subject].coordinates
        began = np.sum([coordinate.speed * np.array(coordinate.axis) for coordinate in own], axis=0)
        across = np.linalg.norm(np.cross(began, velocity), axis=1)
        return degrees(1.0) * np.arctan2(across, velocity @ began)


@quantity
class RadiusOfPath(FreeBodyQuantity):
    """The radius of the circular path of a body in a magnetic field without other forces."""

    name, unit, symbol = "radius of the path", "m", "r"
    floor = 0.1

    def fits(self, mechanism: Mechanism, name: str) -> bool:
        """Return whether the body moves freely in a plane under uniform magnetic fields alone."""
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
    """Return whether one of the body's axes is vertical."""
    return center_path(mechanism, name).rises and any(
        abs(coordinate.axis[2]) > 1.0 - 1e-9 for coordinate in mechanism.body[name].coordinates
    )


class OrbitShape(Quantity):
    """Base class of quantities of a Kepler orbit of a body about a fixed one."""

    of = Pairs()
    drawn_by_recipes = False
    floor = 0.1

    def subjects(self, mechanism: Mechanism) -> tuple[str, ...]:
        """Return the names of attracting pairs of which one body alone moves and is attracted by the other alone."""
        return tuple(PAIR_SEPARATOR.join((pull.a, pull.b)) for pull in mechanism.attractions if _alone(mechanism, pull))


@quantity
class Eccentricity(OrbitShape):
    """The eccentricity of the orbit."""

    name, unit, symbol = "eccentricity", "", "e"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return |v × (r × v) / μ − r / |r||, dimensionless, (n,), with μ = G M of the fixed body."""
        position, velocity, strength = _relative(state, subject)
        turning = np.cross(velocity, np.cross(position, velocity)) / strength
        return np.linalg.norm(turning - position / np.linalg.norm(position, axis=1)[:, None], axis=1)


@quantity
class SemiMajorAxis(OrbitShape):
    """The semi-major axis of the orbit; that of a hyperbola is negative."""

    name, unit, symbol = "semi-major axis", "m", "a"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return 1 / (2 / r − v² / μ) in m, (n,), with μ = G M of the fixed body."""
        position, velocity, strength = _relative(state, subject)
        return 1.0 / (2.0 / np.linalg.norm(position, axis=1) - np.sum(velocity**2, axis=1) / strength)


@quantity
class CircularSpeed(OrbitShape):
    """The speed of a circular orbit at the present distance."""

    name, unit, symbol = "circular speed", "m/s", "v"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return √(μ / r) in m/s, (n,), with μ = G M of the fixed body."""
        position, _, strength = _relative(state, subject)
        return np.sqrt(strength / np.linalg.norm(position, axis=1))


def _alone(mechanism: Mechanism, pull: Attraction) -> bool:
    moving = [name for name in (pull.a, pull.b) if can_move(mechanism, name)]
    others = [other for other in mechanism.attractions if moving and moving[0] in (other.a, other.b)]
    return len(moving) == 1 and others == [pull] and pull.power == 2.0 and not mechanism.forces


def _relative(state: State, subject: str) -> tuple[Array, Array, float]:
    """Return the position and velocity of the moving body relative to the fixed one, (n, 3), and G M."""
    mechanism = state.mechanism
    pull = next(pull for pull in mechanism.attractions if PAIR_SEPARATOR.join((pull.a, pull.b)) == subject)
    planet, star = (pull.a, pull.b) if can_move(mechanism, pull.a) else (pull.b, pull.a)
    position = state.vector(state.frames.center(planet).place) - state.vector(state.frames.center(star).place)
    return position, Velocity.evaluate(state, planet), pull.constant * mechanism.body[star].mass
