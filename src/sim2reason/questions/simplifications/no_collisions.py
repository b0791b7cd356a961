"""Collisions are left out."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class NoCollisions(ChangedMechanism):
    """Collisions are left out, as if bodies went through each other."""

    name = "no collisions"
    reason = "collisions are left out"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where anything can collide."""
        del query
        return [""] if study.mechanism.meetings else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Without them."""
        del subject
        return replace(mechanism, meetings=())
