"""The centre of mass is taken to be at the centre of the figure."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import with_bodies
from sim2reason.dsl.mechanism import ZERO, Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.which import solid
from sim2reason.questions.study import Study


@simplification
class CenterOfMass(ChangedMechanism):
    """A centre of mass is taken to be what the text calls the centre, such as that of a hemisphere's flat face."""

    name = "centre of mass not displaced"
    reason = "the centre of mass of {subject} is taken to be at its geometric centre"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Whatever turns and has its centre of mass elsewhere."""
        del query
        mechanism = study.mechanism
        return [name for name in solid(mechanism) if any(mechanism.body[name].center)]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With its centre of mass there."""
        return with_bodies(mechanism, [subject], lambda body: replace(body, center=ZERO))
