"""What happens on the way is overlooked."""

from collections.abc import Iterable

from sim2reason.dsl.constancy import changing
from sim2reason.dsl.state import Array
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import OtherReading, simplification
from sim2reason.questions.simplifications.parts.asked import asked_until
from sim2reason.questions.simplifications.parts.steady import with_formulas
from sim2reason.questions.study import Study
from sim2reason.simulation.trace import happened


@simplification
class NoEvents(OtherReading):
    """The motion is taken to go on as it begins, whatever happens on the way: stops, slips, collisions."""

    name = "no events"
    reason = "the motion is taken to go on as it begins"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where forces are constant and something happens before the moment."""
        end = asked_until(query, study)
        changes = any(event.time > 0.0 for event in happened(study.trace.events, end))
        return [""] if changes and not changing(study.mechanism) else []

    def read(self, study: Study) -> Study:
        """With the accelerations and forces of the start."""
        return Study(study.scene, with_formulas(study.trace, _continued))


def _continued(t: Array, v: Array, a: Array) -> tuple[Array, Array]:
    return v * t + 0.5 * a * t * t, v + a * t
