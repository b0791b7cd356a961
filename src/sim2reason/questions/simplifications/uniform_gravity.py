"""The attraction of a planet is taken as uniform."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.frames import start
from sim2reason.dsl.mechanism import Attraction, Mechanism
from sim2reason.dsl.triples import minus
from sim2reason.dsl.vectors import Vector, scale
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class UniformGravity(ChangedMechanism):
    """What leaves a planet is taken to weigh as much everywhere as where it starts."""

    name = "uniform gravity"
    reason = "gravity is taken to be everywhere what it is at the start"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where one body burns and another attracts it."""
        del query
        return [""] if len(study.mechanism.attractions) == 1 and study.mechanism.burns else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With uniform gravity instead."""
        del subject
        (pull,) = mechanism.attractions
        return replace(mechanism, attractions=(), gravity=_free_fall(mechanism, pull))


def _free_fall(mechanism: Mechanism, pull: Attraction) -> Vector:
    """The acceleration, m/s², that the attraction gives at the start to the one of both that burns."""
    falling = mechanism.burns[0].body
    other = pull.b if falling == pull.a else pull.a
    frames = start(mechanism)
    x, y, z = (float(part) for part in minus(frames.center(other).place, frames.center(falling).place))
    distance = (x * x + y * y + z * z) ** 0.5
    return scale(pull.constant * mechanism.body[other].mass / distance ** (pull.power + 1.0), (x, y, z))
