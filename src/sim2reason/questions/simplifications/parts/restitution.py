"""Base class of misconceptions with one coefficient of restitution for all collisions."""

from collections.abc import Iterable
from dataclasses import replace
from typing import ClassVar

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.mechanism import Mechanism


class OneRestitution(ChangedMechanism):
    """The base class of misconceptions that assume one coefficient of restitution for all collisions.

    Class data:
        restitution: the coefficient.
    """

    restitution: ClassVar[float]

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a collision has another coefficient; else none."""
        del query
        return [""] if any(meeting.restitution != self.restitution for meeting in study.mechanism.meetings) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with the assumed coefficient of restitution in all collisions."""
        del subject
        same = tuple(replace(meeting, restitution=self.restitution, sticks=False) for meeting in mechanism.meetings)
        return replace(mechanism, meetings=same)
