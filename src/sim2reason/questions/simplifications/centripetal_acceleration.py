"""The acceleration on any orbit is taken to be v²/r."""

from collections.abc import Iterable

from sim2reason.dsl.state import Array
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import OtherReading, simplification
from sim2reason.questions.simplifications.parts.asked import asked_name
from sim2reason.questions.simplifications.parts.orbits import ACCELERATIONS, PlanetOrbit, orbits, with_accelerations
from sim2reason.questions.study import Study


@simplification
class CentripetalAcceleration(OtherReading):
    """The acceleration is taken to be v²/r towards the star, as on a circle."""

    name = "centripetal acceleration"
    reason = "the acceleration is taken to be v\N{SUPERSCRIPT TWO}/r, as on a circle about the star"
    sound_if_same = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where planets go round a star, and something is asked that hangs on it."""
        return [""] if asked_name(query) in ACCELERATIONS and orbits(study.mechanism) else []

    def read(self, study: Study) -> Study:
        """With that acceleration."""
        return Study(study.scene, with_accelerations(study.trace, _towards_the_star))


def _towards_the_star(orbit: PlanetOrbit, place: Array, velocity: Array) -> Array:
    del orbit
    return -place * (velocity**2).sum(axis=1, keepdims=True) / (place**2).sum(axis=1, keepdims=True)
