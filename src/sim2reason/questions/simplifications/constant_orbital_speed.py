"""The speed of a planet is taken to stay the same."""

from collections.abc import Iterable
from math import hypot

from sim2reason.dsl.state import Array
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import OtherReading, simplification
from sim2reason.questions.simplifications.parts.asked import asked_name
from sim2reason.questions.simplifications.parts.orbits import SPEEDS, PlanetOrbit, directed, orbits, with_velocities
from sim2reason.questions.study import Study


@simplification
class ConstantOrbitalSpeed(OtherReading):
    """A planet is taken to be everywhere as fast as at the start, though its distance changes."""

    name = "constant orbital speed"
    reason = "the speed is taken to be the same all along the orbit"
    sound_if_same = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where planets go round a star, and something is asked that hangs on it."""
        return [""] if asked_name(query) in SPEEDS and orbits(study.mechanism) else []

    def read(self, study: Study) -> Study:
        """With velocities as large as those of the start."""
        return Study(study.scene, with_velocities(study.trace, _as_at_first))


def _as_at_first(orbit: PlanetOrbit, place: Array, velocity: Array) -> Array:
    del place
    return directed(velocity, hypot(*orbit.velocity))
