"""A force of a field or of a medium is left out."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class ForceLeftOut(ChangedMechanism):
    """The force of a field, or the drag of a medium, is left out."""

    name = "force left out"
    reason = "the force of {subject} is left out"
    part = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """All of them."""
        del query
        return [force.name for force in study.mechanism.forces]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Without it."""
        return replace(mechanism, forces=tuple(force for force in mechanism.forces if force.name != subject))
