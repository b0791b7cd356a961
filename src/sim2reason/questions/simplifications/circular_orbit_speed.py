"""The formulas of a circular orbit are used at the momentary distance."""

from collections.abc import Iterable

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import OtherReading, simplification
from sim2reason.questions.simplifications.parts.asked import asked_name
from sim2reason.questions.simplifications.parts.orbits import SPEEDS, PlanetOrbit, directed, orbits, with_velocities
from sim2reason.questions.study import Study


@simplification
class CircularOrbitSpeed(OtherReading):
    """A planet is taken to have the speed of a circle at the distance that it has just then."""

    name = "circular orbit speed"
    reason = "the speed is taken to be that on a circle at the momentary distance, \N{SQUARE ROOT}(GM/r)"
    sound_if_same = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where planets go round a star, and something is asked that hangs on it."""
        return [""] if asked_name(query) in SPEEDS and orbits(study.mechanism) else []

    def read(self, study: Study) -> Study:
        """With v² = GM/r."""
        return Study(study.scene, with_velocities(study.trace, _as_on_a_circle))


def _as_on_a_circle(orbit: PlanetOrbit, place: Array, velocity: Array) -> Array:
    distance = np.linalg.norm(place, axis=1, keepdims=True)
    return directed(velocity, np.sqrt(orbit.gravitational_parameter / distance))
