"""A planet is taken to sweep out equal angles in equal times."""

from collections.abc import Iterable
from functools import partial
from math import pi

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import OtherReading, simplification
from sim2reason.questions.simplifications.parts.orbits import Motion, PlanetOrbit, moving_as, orbits
from sim2reason.questions.study import Study


@simplification
class UniformAngularSpeed(OtherReading):
    """Equal times are taken to belong to equal angles on an ellipse, not to equal areas."""

    name = "uniform angular speed"
    reason = "equal angles are taken to be swept out in equal times, as on a circle"
    sound_if_same = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where planets go round a star and return."""
        del query
        found = orbits(study.mechanism)
        return [""] if found and all(orbit.period is not None for orbit in found) else []

    def read(self, study: Study) -> Study:
        """On their ellipses about the star alone, in the periods that they have there."""
        ellipses = {orbit: partial(_turned, orbit) for orbit in orbits(study.mechanism)}
        return Study(study.scene, moving_as(study.trace, ellipses))


def _turned(orbit: PlanetOrbit, times: Array) -> Motion:
    """With r = p/(1 + e cos ν), ṙ = r² e sin ν ω/p and r̈ = (2ṙ²/r + r² e cos ν ω²/p)."""
    assert orbit.period is not None
    rate, p, (ex, ey) = orbit.sense * 2.0 * pi / orbit.period, orbit.semi_latus_rectum, orbit.eccentricity_vector
    angle = np.arctan2(orbit.place[1], orbit.place[0]) + rate * times
    out = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    along = np.stack([-out[:, 1], out[:, 0]], axis=1)
    ahead, aside = (out @ np.array([ex, ey]))[:, None], (along @ np.array([ex, ey]))[:, None]  # e cos ν, −e sin ν
    r = p / (1.0 + ahead)
    faster = -(r**2) * aside * rate / p
    outward = 2.0 * faster**2 / r + r**2 * ahead * rate**2 / p
    velocity = faster * out + r * rate * along
    return r * out, velocity, (outward - r * rate**2) * out + 2.0 * faster * rate * along
