"""Collisions are taken as perfectly inelastic."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study

RESTITUTION = 0.0


@simplification
class PerfectlyInelasticCollisions(ChangedMechanism):
    """Collisions are taken as perfectly inelastic."""

    name = "perfectly inelastic collisions"
    reason = "every collision is taken as perfectly inelastic"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where any is not."""
        del query
        return [""] if any(meeting.restitution != RESTITUTION for meeting in study.mechanism.meetings) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With the coefficient of restitution zero everywhere."""
        del subject
        meetings = tuple(replace(meeting, restitution=RESTITUTION, sticks=False) for meeting in mechanism.meetings)
        return replace(mechanism, meetings=meetings)
