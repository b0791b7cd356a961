"""Bodies with a size are taken as points."""

from collections.abc import Iterable

from sim2reason.dsl.ablation import inertialess, with_bodies
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.which import solid
from sim2reason.questions.study import Study


@simplification
class PointMass(ChangedMechanism):
    """Bodies with a size are taken as points at their centres of mass; what rolls then only slides."""

    name = "point mass"
    reason = "the moment of inertia about the centre of mass is left out"
    common = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where anything with inertia about its centre of mass can turn."""
        del query
        return [""] if solid(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Without that inertia."""
        del subject
        return with_bodies(mechanism, solid(mechanism), inertialess)
