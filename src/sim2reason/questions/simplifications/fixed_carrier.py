"""A wedge, a box or a carriage is taken as fixed."""

from collections.abc import Iterable

from sim2reason.dsl.ablation import held
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.which import carriers
from sim2reason.questions.study import Study


@simplification
class FixedCarrier(ChangedMechanism):
    """What carries others, such as a wedge, is taken as fixed."""

    name = "fixed carrier"
    reason = "{subject} is taken as fixed"
    holds = True
    common = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Whatever carries something and can move."""
        del query
        return carriers(study.mechanism)

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With it held."""
        return held(mechanism, subject)
