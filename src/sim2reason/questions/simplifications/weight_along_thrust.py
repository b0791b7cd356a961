"""Weight is added to the thrust."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.mobility import weighs
from sim2reason.dsl.vectors import scale
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class WeightAlongThrust(ChangedMechanism):
    """The weight of a rocket is added to its thrust, not subtracted from it."""

    name = "weight along the thrust"
    reason = "the weight of {subject} is added to the thrust instead of being subtracted"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return the bodies that burn fuel if there is gravity; else none."""
        del query
        mechanism = study.mechanism
        return [burn.body for burn in mechanism.burns] if weighs(mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with gravity reversed."""
        del subject
        return replace(mechanism, gravity=scale(-1.0, mechanism.gravity))
