"""A pulley is taken as light."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import NEARLY_NOTHING, with_bodies
from sim2reason.dsl.mechanism import Mechanism, RigidBody
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.which import wheels
from sim2reason.questions.study import Study


@simplification
class MasslessPulley(ChangedMechanism):
    """The inertia of all pulleys is left out."""

    name = "massless pulley"
    reason = "pulleys are taken as light"
    common = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """All pulleys at once."""
        del query
        return [""] if wheels(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With next to no mass and inertia in them."""
        del subject
        return with_bodies(mechanism, wheels(mechanism), _light)


def _light(body: RigidBody) -> RigidBody:
    inertia = tuple(NEARLY_NOTHING * part for part in body.inertia)
    return replace(body, mass=NEARLY_NOTHING * body.mass, inertia=inertia)
