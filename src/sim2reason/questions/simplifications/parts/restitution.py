"""What slips share that take every collision to be of one kind."""

from collections.abc import Iterable
from dataclasses import replace
from typing import ClassVar

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism
from sim2reason.questions.study import Study
from sim2reason.scenes.dsl.mechanism import Mechanism


class OneRestitution(ChangedMechanism):
    """Every collision is taken to have one coefficient of restitution.

    Class data:
        restitution: the coefficient.
    """

    restitution: ClassVar[float]

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return the whole, where any has another."""
        del query
        return [""] if any(meeting.restitution != self.restitution for meeting in study.mechanism.meetings) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with that coefficient everywhere."""
        del subject
        same = tuple(replace(meeting, restitution=self.restitution, sticks=False) for meeting in mechanism.meetings)
        return replace(mechanism, meetings=same)
