"""A movable pulley is taken as fixed."""

from collections.abc import Iterable

from sim2reason.dsl.ablation import held
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.hanging import movable_pulleys
from sim2reason.questions.study import Study


@simplification
class FixedMovablePulley(ChangedMechanism):
    """The acceleration relative to a movable pulley is taken for that relative to the ground."""

    name = "fixed movable pulley"
    reason = "a movable pulley is taken as fixed"
    holds = True
    sound_if_same = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """All movable pulleys."""
        del query
        return movable_pulleys(study.mechanism)

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With it held."""
        return held(mechanism, subject)
