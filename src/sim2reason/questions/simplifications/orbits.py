"""Misconceptions about orbits, and altered motions of planets about a fixed star."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import partial
from math import copysign, hypot, pi, sqrt

import numpy as np

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, MisinterpretedMotion, misconception
from sim2reason.questions.simplifications.events import asked_name
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Attraction, Mechanism
from sim2reason.scenes.dsl.state import Array, Dynamics, State
from sim2reason.scenes.dsl.vectors import dot, subtract_triples
from sim2reason.simulation.trace import Trace

RIGHT_ANGLE_COSINE_TOL = 1e-9  # cosine of a right angle
SPEEDS = {"velocity", "momentum", "kinetic energy", "greatest speed", "least speed"}
ACCELERATIONS = {"acceleration", "net force", "greatest acceleration", "least acceleration"}
"""What is asked for that hangs on the speed, or on the acceleration, by name."""
Motion = tuple[Array, Array, Array]
"""Places from the star on, velocities and accelerations, (n, 2) each."""
OrbitFormula = Callable[["PlanetOrbit", Array, Array], Array]
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
    frames, planet_orbits = initial_frames(mechanism), list[PlanetOrbit]()
    for pull in mechanism.attractions:
        star, planet = sorted((pull.a, pull.b), key=lambda name: len(mechanism.body[name].coordinates))
        coordinates = mechanism.body[planet].coordinates
        if mechanism.body[star].coordinates:
            continue
        axes = [c.axis for c in coordinates if c.kind == "slide"]
        if len(coordinates) != 2 or len(axes) != 2 or abs(dot(*axes)) > RIGHT_ANGLE_COSINE_TOL:
            return []
        away = subtract_triples(frames.center(planet).place, frames.center(star).place)
        x, y = (float(dot(away, axis)) for axis in axes)
        one, other = (mechanism.number[c.name] for c in coordinates)
        velocity = coordinates[0].speed, coordinates[1].speed
        strength = pull.constant * mechanism.body[star].mass
        planet_orbits.append(PlanetOrbit((one, other), strength, (x, y), velocity))
    return planet_orbits if 2 * len(planet_orbits) == len(mechanism.coordinates) else []


def moving_as(trace: Trace, formulas: Mapping[PlanetOrbit, Callable[[Array], Motion]]) -> Trace:
    """Return a motion in which planets move by formulas of the time (n,)."""

    def sample(times: Array) -> State:
        q, v, a = (np.zeros((len(times), len(trace.mechanism.coordinates))) for _ in range(3))
        for orbit, formula in formulas.items():
            position, velocity, acceleration = formula(times)
            columns = list(orbit.numbers)
            q[:, columns], v[:, columns], a[:, columns] = position - np.array(orbit.place), velocity, acceleration
        return State.of(trace.mechanism, times, (q, v), Dynamics(a, {}, {}, {}))

    return _read(trace, sample)


def with_velocities(trace: Trace, velocity: OrbitFormula) -> Trace:
    """Return a motion along the same paths at the same times, with other velocities."""
    planet_orbits = orbits(trace.mechanism)
    return _retold(trace, lambda state: (_told(state, planet_orbits, velocity), state.a))


def with_accelerations(trace: Trace, acceleration: OrbitFormula) -> Trace:
    """Return a motion with the given positions and velocities, but other accelerations."""
    planet_orbits = orbits(trace.mechanism)
    return _retold(trace, lambda state: (state.v, _told(state, planet_orbits, acceleration)))


def _retold(trace: Trace, rates: Callable[[State], tuple[Array, Array]]) -> Trace:
    """Return a motion with the positions of another one, and with new velocities and accelerations, (n, c) each."""

    def sample(times: Array) -> State:
        state = trace.sample(times)
        return State(
            trace.mechanism,
            times,
            lambda _: (state.q, rates(state)[0]),
            lambda _, __, ___: Dynamics(rates(state)[1], {}, {}, {}),
        )

    return replace(_read(trace, sample), knots=trace.knots)


def _told(state: State, planet_orbits: Iterable[PlanetOrbit], formula: OrbitFormula) -> Array:
    values = np.zeros_like(state.q)
    for orbit in planet_orbits:
        columns = list(orbit.numbers)
        values[:, columns] = formula(orbit, np.array(orbit.place) + state.q[:, columns], state.v[:, columns])
    return values


def _read(trace: Trace, sample: Callable[[Array], State]) -> Trace:
    end = float(trace.state.times[-1])
    return Trace(trace.engine, sample(trace.state.times), (), end, "", sample, lambda: np.linspace(0.0, end, 33))


def scale_to_speed(velocity: Array, speed: Array | float) -> Array:
    """Return velocities with given speeds in the directions of others, (n, 3); zero for bodies at rest."""
    now = np.linalg.norm(velocity, axis=1, keepdims=True)
    return np.divide(velocity * speed, now, out=np.zeros_like(velocity), where=now > 0.0)


@misconception
class CentripetalAcceleration(MisinterpretedMotion):
    """The acceleration is taken to be v²/r towards the star, as on a circle."""

    name = "centripetal acceleration"
    reason = "the acceleration is taken to be v\N{SUPERSCRIPT TWO}/r, as on a circle about the star"
    sound_if_same = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if planets orbit a star and accelerations matter; else none."""
        return [""] if asked_name(query) in ACCELERATIONS and orbits(study.mechanism) else []

    def read(self, study: SimulatedScene) -> SimulatedScene:
        """Return the motion with the accelerations v²/r towards the star."""
        return SimulatedScene(study.scene, with_accelerations(study.trace, _towards_the_star))


def _towards_the_star(orbit: PlanetOrbit, position: Array, velocity: Array) -> Array:
    del orbit
    return -position * (velocity**2).sum(axis=1, keepdims=True) / (position**2).sum(axis=1, keepdims=True)


@misconception
class CircularOrbit(MisinterpretedMotion):
    """A planet is assumed to be on a circular orbit with its initial distance from the star."""

    name = "circular orbit"
    reason = "the orbit is taken as a circle about the star through the starting point"
    sound_if_same = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if planets orbit a star; else none."""
        del query
        return [""] if orbits(study.mechanism) else []

    def read(self, study: SimulatedScene) -> SimulatedScene:
        """Return the motion of all planets on circles about the star, with ω² = GM/r³."""
        circles = {orbit: partial(_circle, orbit) for orbit in orbits(study.mechanism)}
        return SimulatedScene(study.scene, moving_as(study.trace, circles))


def _circle(orbit: PlanetOrbit, times: Array) -> Motion:
    r = orbit.distance
    rate = orbit.sense * sqrt(orbit.gravitational_parameter / r**3)
    angle = np.arctan2(orbit.place[1], orbit.place[0]) + rate * times
    out = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    along = np.stack([-out[:, 1], out[:, 0]], axis=1)
    return r * out, r * rate * along, -r * rate**2 * out


@misconception
class CircularOrbitSpeed(MisinterpretedMotion):
    """A planet is assumed to have, at each distance, the speed of a circular orbit there."""

    name = "circular orbit speed"
    reason = "the speed is taken to be that on a circle at the momentary distance, \N{SQUARE ROOT}(GM/r)"
    sound_if_same = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if planets orbit a star and the query needs speeds; else none."""
        return [""] if asked_name(query) in SPEEDS and orbits(study.mechanism) else []

    def read(self, study: SimulatedScene) -> SimulatedScene:
        """Return the motion along the same paths with the speeds of circular orbits, v² = GM/r."""
        return SimulatedScene(study.scene, with_velocities(study.trace, _as_on_a_circle))


def _as_on_a_circle(orbit: PlanetOrbit, position: Array, velocity: Array) -> Array:
    distance = np.linalg.norm(position, axis=1, keepdims=True)
    return scale_to_speed(velocity, np.sqrt(orbit.gravitational_parameter / distance))


@misconception
class ConstantOrbitalSpeed(MisinterpretedMotion):
    """A planet is assumed to keep its initial speed, although its distance changes."""

    name = "constant orbital speed"
    reason = "the speed is taken to be the same all along the orbit"
    sound_if_same = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if planets orbit a star and the query needs speeds; else none."""
        return [""] if asked_name(query) in SPEEDS and orbits(study.mechanism) else []

    def read(self, study: SimulatedScene) -> SimulatedScene:
        """Return the motion along the same paths with each planet's initial speed throughout."""
        return SimulatedScene(study.scene, with_velocities(study.trace, _as_at_first))


def _as_at_first(orbit: PlanetOrbit, position: Array, velocity: Array) -> Array:
    del position
    return scale_to_speed(velocity, hypot(*orbit.velocity))


@misconception
class NoMutualAttraction(ChangedMechanism):
    """Moving bodies, such as planets of one star, are assumed not to attract each other."""

    name = "no mutual attraction"
    reason = "the attraction between the moving bodies is left out"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if moving bodies attract each other and a fixed one; else none."""
        del query
        mechanism = study.mechanism
        mutual = [_is_mutual(mechanism, pull) for pull in mechanism.attractions]
        return [""] if any(mutual) and not all(mutual) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism without mutual attraction of moving bodies."""
        del subject
        kept = tuple(pull for pull in mechanism.attractions if not _is_mutual(mechanism, pull))
        return replace(mechanism, attractions=kept)


def _is_mutual(mechanism: Mechanism, pull: Attraction) -> bool:
    return all(mechanism.body[name].coordinates for name in (pull.a, pull.b))
