"""One of several bodies with a size is taken as a point."""

from collections.abc import Iterable

from sim2reason.dsl.ablation import inertialess, with_bodies
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.which import solid
from sim2reason.questions.study import Study


@simplification
class OwnInertia(ChangedMechanism):
    """The moment of inertia of one body about its own centre of mass is left out, but that of others is kept."""

    name = "own inertia left out"
    common = True
    reason = "the moment of inertia of {subject} about its own centre of mass is left out"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Each of several; a single one is covered by taking all bodies as points."""
        del query
        found = solid(study.mechanism)
        return found if len(found) > 1 else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Without that inertia."""
        return with_bodies(mechanism, [subject], inertialess)
