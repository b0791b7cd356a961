"""An orbit is taken as a circle."""

from collections.abc import Iterable
from functools import partial
from math import sqrt

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import OtherReading, simplification
from sim2reason.questions.simplifications.parts.orbits import Motion, PlanetOrbit, moving_as, orbits
from sim2reason.questions.study import Study


@simplification
class CircularOrbit(OtherReading):
    """A planet is taken to go round its star at the distance that it has at the start, as fast as on a circle."""

    name = "circular orbit"
    reason = "the orbit is taken as a circle about the star through the starting point"
    sound_if_same = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where planets go round a star."""
        del query
        return [""] if orbits(study.mechanism) else []

    def read(self, study: Study) -> Study:
        """On circles, with ω² = GM/r³."""
        circles = {orbit: partial(_circle, orbit) for orbit in orbits(study.mechanism)}
        return Study(study.scene, moving_as(study.trace, circles))


def _circle(orbit: PlanetOrbit, times: Array) -> Motion:
    r = orbit.distance
    rate = orbit.sense * sqrt(orbit.gravitational_parameter / r**3)
    angle = np.arctan2(orbit.place[1], orbit.place[0]) + rate * times
    out = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    along = np.stack([-out[:, 1], out[:, 0]], axis=1)
    return r * out, r * rate * along, -r * rate**2 * out
