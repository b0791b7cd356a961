"""Planets about a fixed star, and altered motions of them."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from math import copysign, hypot, pi, sqrt

import numpy as np

from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, Dynamics, State
from sim2reason.scenes.dsl.vectors import dot, minus
from sim2reason.simulation.trace import Trace

SQUARE = 1e-9  # cosine of a right angle
SPEEDS = {"velocity", "momentum", "kinetic energy", "greatest speed", "least speed"}
ACCELERATIONS = {"acceleration", "net force", "greatest acceleration", "least acceleration"}
"""What is asked for that hangs on the speed, or on the acceleration, by name."""
Motion = tuple[Array, Array, Array]
"""Places from the star on, velocities and accelerations, (n, 2) each."""
Told = Callable[["PlanetOrbit", Array, Array], Array]
"""What is taken for the velocity or the acceleration on an orbit, from places and velocities, (n, 2) each."""


@dataclass(frozen=True, slots=True)
class PlanetOrbit:
    """A planet's initial state in the plane of its two coordinates, whose indices are `numbers`."""

    numbers: tuple[int, int]
    gravitational_parameter: float  # G M
    place: tuple[float, float]  # from the star on
    velocity: tuple[float, float]

    @property
    def distance(self) -> float:
        """Return the initial distance from the star, m."""
        return hypot(*self.place)

    @property
    def angular_momentum(self) -> float:
        """Return the angular momentum about the star per mass, m²/s; positive if counter-clockwise."""
        (x, y), (vx, vy) = self.place, self.velocity
        return x * vy - y * vx

    @property
    def sense(self) -> float:
        """Return 1 for a counter-clockwise orbit, else −1."""
        return copysign(1.0, self.angular_momentum)

    @property
    def eccentricity_vector(self) -> tuple[float, float]:
        """Return the eccentricity vector v × h/GM − r/r, which points to the periapsis."""
        (x, y), (vx, vy) = self.place, self.velocity
        h, mu = self.angular_momentum, self.gravitational_parameter
        return vy * h / mu - x / self.distance, -vx * h / mu - y / self.distance

    @property
    def semi_latus_rectum(self) -> float:
        """Return the semi-latus rectum h²/GM, m."""
        return self.angular_momentum**2 / self.gravitational_parameter

    @property
    def period(self) -> float | None:
        """Return the period by Kepler's third law, s; None for an open orbit."""
        left = 1.0 - hypot(*self.eccentricity_vector) ** 2
        if left <= 0.0:
            return None
        return 2.0 * pi * sqrt((self.semi_latus_rectum / left) ** 3 / self.gravitational_parameter)


def orbits(mechanism: Mechanism) -> list[PlanetOrbit]:
    """Return the planets of a fixed star, if the mechanism contains nothing else; else none."""
    if len({pull.power for pull in mechanism.attractions} | {2.0}) > 1 or mechanism.burns or mechanism.lines:
        return []
    frames, found = initial_frames(mechanism), list[PlanetOrbit]()
    for pull in mechanism.attractions:
        star, planet = sorted((pull.a, pull.b), key=lambda name: len(mechanism.body[name].coordinates))
        coordinates = mechanism.body[planet].coordinates
        if mechanism.body[star].coordinates:
            continue
        axes = [c.axis for c in coordinates if c.kind == "slide"]
        if len(coordinates) != 2 or len(axes) != 2 or abs(dot(*axes)) > SQUARE:
            return []
        away = minus(frames.center(planet).place, frames.center(star).place)
        x, y = (float(dot(away, axis)) for axis in axes)
        one, other = (mechanism.number[c.name] for c in coordinates)
        velocity = coordinates[0].speed, coordinates[1].speed
        strength = pull.constant * mechanism.body[star].mass
        found.append(PlanetOrbit((one, other), strength, (x, y), velocity))
    return found if 2 * len(found) == len(mechanism.coordinates) else []


def moving_as(trace: Trace, formulas: Mapping[PlanetOrbit, Callable[[Array], Motion]]) -> Trace:
    """Return a motion in which planets move by formulas of the time (n,)."""

    def sample(times: Array) -> State:
        q, v, a = (np.zeros((len(times), len(trace.mechanism.coordinates))) for _ in range(3))
        for orbit, formula in formulas.items():
            place, velocity, acceleration = formula(times)
            columns = list(orbit.numbers)
            q[:, columns], v[:, columns], a[:, columns] = place - np.array(orbit.place), velocity, acceleration
        return State.of(trace.mechanism, times, (q, v), Dynamics(a, {}, {}, {}))

    return _read(trace, sample)


def with_velocities(trace: Trace, velocity: Told) -> Trace:
    """Return a motion along the same paths at the same times, with other velocities."""
    found = orbits(trace.mechanism)
    return _retold(trace, lambda state: (_told(state, found, velocity), state.a))


def with_accelerations(trace: Trace, acceleration: Told) -> Trace:
    """Return a motion with the given positions and velocities, but other accelerations."""
    found = orbits(trace.mechanism)
    return _retold(trace, lambda state: (state.v, _told(state, found, acceleration)))


def _retold(trace: Trace, rates: Callable[[State], tuple[Array, Array]]) -> Trace:
    """Return a motion with the positions of another one, and with new velocities and accelerations, (n, c) each."""

    def sample(times: Array) -> State:
        state = trace.sample(times)
        return State(
            trace.mechanism,
            times,
            lambda: (state.q, rates(state)[0]),
            lambda _, __: Dynamics(rates(state)[1], {}, {}, {}),
        )

    return replace(_read(trace, sample), knots=trace.knots)


def _told(state: State, found: Iterable[PlanetOrbit], told: Told) -> Array:
    values = np.zeros_like(state.q)
    for orbit in found:
        columns = list(orbit.numbers)
        values[:, columns] = told(orbit, np.array(orbit.place) + state.q[:, columns], state.v[:, columns])
    return values


def _read(trace: Trace, sample: Callable[[Array], State]) -> Trace:
    end = float(trace.state.times[-1])
    return Trace(trace.engine, sample(trace.state.times), (), end, "", sample, lambda: np.linspace(0.0, end, 33))


def directed(velocity: Array, speed: Array | float) -> Array:
    """Return velocities with given speeds in the directions of others, (n, 3); zero for bodies at rest."""
    now = np.linalg.norm(velocity, axis=1, keepdims=True)
    return np.divide(velocity * speed, now, out=np.zeros_like(velocity), where=now > 0.0)
