"""The rotation of all pulleys is forgotten, though not their weight."""

from collections.abc import Iterable

from sim2reason.dsl.ablation import with_bodies
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.hanging import carried
from sim2reason.questions.simplifications.parts.which import wheels
from sim2reason.questions.simplifications.pulley_rotation import without_rotation
from sim2reason.questions.study import Study


@simplification
class PulleyRotationsLeftOut(ChangedMechanism):
    """The rotational inertia of all pulleys is left out; the mass of those that move along is kept."""

    name = "pulley rotations left out"
    reason = "the rotational inertia of all pulleys is left out"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """All of several at once, if one of them moves along; else taking them as light is the same."""
        del query
        turning = wheels(study.mechanism)
        several = len(turning) > 1 and any(carried(study.mechanism, name) is not None for name in turning)
        return [""] if several else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With next to no moments of inertia."""
        del subject
        return with_bodies(mechanism, wheels(mechanism), without_rotation)
