"""Misconceptions about orbits."""

from collections.abc import Iterable
from dataclasses import replace
from functools import partial
from math import hypot, sqrt

import numpy as np

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, MisinterpretedMotion, misconception
from sim2reason.questions.simplifications.parts.asked import asked_name
from sim2reason.questions.simplifications.parts.orbits import (
    ACCELERATIONS,
    SPEEDS,
    Motion,
    PlanetOrbit,
    directed,
    moving_as,
    orbits,
    with_accelerations,
    with_velocities,
)
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.mechanism import Attraction, Mechanism
from sim2reason.scenes.dsl.state import Array


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


def _towards_the_star(orbit: PlanetOrbit, place: Array, velocity: Array) -> Array:
    del orbit
    return -place * (velocity**2).sum(axis=1, keepdims=True) / (place**2).sum(axis=1, keepdims=True)


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


def _as_on_a_circle(orbit: PlanetOrbit, place: Array, velocity: Array) -> Array:
    distance = np.linalg.norm(place, axis=1, keepdims=True)
    return directed(velocity, np.sqrt(orbit.gravitational_parameter / distance))


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


def _as_at_first(orbit: PlanetOrbit, place: Array, velocity: Array) -> Array:
    del place
    return directed(velocity, hypot(*orbit.velocity))


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
