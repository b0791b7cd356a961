"""Sine and cosine of an angle are confused."""

from collections.abc import Iterable

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import Simplification, simplification
from sim2reason.questions.study import Study


@simplification
class SineForCosine(Simplification):
    """An acute angle is taken from the other leg: its complement stands wherever it should."""

    name = "sine for cosine"
    common = True
    reason = "sine and cosine of an angle are confused"
    sound_if_same = True  # then both enter alike, as in the range of a throw

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The addresses of all acute angles that the text states."""
        del query
        return [
            parameter.path
            for parameter in study.scene.parameters
            if parameter.measure.unit == "deg"
            and not parameter.hidden
            and parameter.value is not None
            and 0.0 < parameter.value < 90.0
        ]

    def simplified(self, study: Study, subject: str, until: float) -> Study | None:
        """The scene with the complement of that angle; None if it can't be built so."""
        return study.with_values({subject: 90.0 - float(study.scene.value(subject))}, until)
