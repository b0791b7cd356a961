"""The factor ½ of ½at² is forgotten."""

from collections.abc import Iterable

from sim2reason.dsl.state import Array
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import OtherReading, simplification
from sim2reason.questions.simplifications.parts.steady import is_steady, with_formulas
from sim2reason.questions.study import Study


@simplification
class HalfForgotten(OtherReading):
    """What is let go is taken to move by at², as if it had all the while the speed that it reaches."""

    name = "half forgotten"
    reason = "the distance covered from rest is taken to be a t\N{SUPERSCRIPT TWO}, without the factor 1/2"
    sound_if_same = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where all accelerations are constant."""
        return [""] if is_steady(query, study) else []

    def read(self, study: Study) -> Study:
        """With distances twice as large, and the speeds of the same times."""
        return Study(study.scene, with_formulas(study.trace, _doubled))


def _doubled(t: Array, v: Array, a: Array) -> tuple[Array, Array]:
    return v * t + a * t * t, v + a * t
