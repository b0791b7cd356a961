"""Weight is left out."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import NEARLY_NOTHING
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.mobility import weighs
from sim2reason.dsl.vectors import scale
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class GravityLeftOut(ChangedMechanism):
    """Weight is left out."""

    name = "gravity left out"
    reason = "weight is left out"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where anything weighs."""
        del query
        return [""] if weighs(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With next to no gravity, so that there still is an up and a down."""
        del subject
        return replace(mechanism, gravity=scale(NEARLY_NOTHING, mechanism.gravity))
