"""The mean velocity is taken for the velocity at the end."""

from collections.abc import Iterable

from sim2reason.dsl.state import Array
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import OtherReading, simplification
from sim2reason.questions.simplifications.parts.steady import is_steady, with_formulas
from sim2reason.questions.study import Study


@simplification
class MeanVelocity(OtherReading):
    """A velocity is taken to be the distance over the time, also of what speeds up."""

    name = "mean velocity"
    reason = "the mean velocity is taken for the velocity at the end"
    sound_if_same = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where all accelerations are constant."""
        return [""] if is_steady(query, study) else []

    def read(self, study: Study) -> Study:
        """With half the velocities."""
        return Study(study.scene, with_formulas(study.trace, _averaged))


def _averaged(t: Array, v: Array, a: Array) -> tuple[Array, Array]:
    return v * t + 0.5 * a * t * t, v + 0.5 * a * t
