"""The shape of the orbit of a body about a fixed one: for structured questions only, not drawn by recipes."""

import numpy as np

from sim2reason.scenes.dsl.mechanism import Attraction, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities import Quantity, quantity
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.quantities.subjects.bodies import can_move
from sim2reason.simulation.quantities.subjects.pairs import PAIR_SEPARATOR, Pairs


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
        place, velocity, strength = _relative(state, subject)
        turning = np.cross(velocity, np.cross(place, velocity)) / strength
        return np.linalg.norm(turning - place / np.linalg.norm(place, axis=1)[:, None], axis=1)


@quantity
class SemiMajorAxis(OrbitShape):
    """The semi-major axis of the orbit; that of a hyperbola is negative."""

    name, unit, symbol = "semi-major axis", "m", "a"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return 1 / (2 / r − v² / μ) in m, (n,), with μ = G M of the fixed body."""
        place, velocity, strength = _relative(state, subject)
        return 1.0 / (2.0 / np.linalg.norm(place, axis=1) - np.sum(velocity**2, axis=1) / strength)


@quantity
class CircularSpeed(OrbitShape):
    """The speed of a circular orbit at the present distance."""

    name, unit, symbol = "circular speed", "m/s", "v"

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Return √(μ / r) in m/s, (n,), with μ = G M of the fixed body."""
        place, _, strength = _relative(state, subject)
        return np.sqrt(strength / np.linalg.norm(place, axis=1))


def _alone(mechanism: Mechanism, pull: Attraction) -> bool:
    moving = [name for name in (pull.a, pull.b) if can_move(mechanism, name)]
    others = [other for other in mechanism.attractions if moving and moving[0] in (other.a, other.b)]
    return len(moving) == 1 and others == [pull] and pull.power == 2.0 and not mechanism.forces


def _relative(state: State, subject: str) -> tuple[Array, Array, float]:
    """Return the position and velocity of the moving body relative to the fixed one, (n, 3), and G M."""
    mechanism = state.mechanism
    pull = next(pull for pull in mechanism.attractions if PAIR_SEPARATOR.join((pull.a, pull.b)) == subject)
    planet, star = (pull.a, pull.b) if can_move(mechanism, pull.a) else (pull.b, pull.a)
    apart = state.vector(state.frames.center(planet).place) - state.vector(state.frames.center(star).place)
    return apart, Velocity.evaluate(state, planet), pull.constant * mechanism.body[star].mass
