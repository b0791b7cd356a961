"""What moves at the start is taken to be at rest."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import with_bodies
from sim2reason.dsl.mechanism import Mechanism, RigidBody
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class FromRest(ChangedMechanism):
    """What moves at the start is taken to be at rest."""

    name = "from rest"
    common = True
    reason = "the velocity at the start is left out"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where anything moves at the start; but nobody has planets fall into their star."""
        del query
        moving = any(coordinate.speed for coordinate in study.mechanism.coordinates)
        return [""] if moving and not study.mechanism.attractions else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With all at rest."""
        del subject
        return with_bodies(mechanism, mechanism.body, _still)


def _still(body: RigidBody) -> RigidBody:
    return replace(body, coordinates=tuple(replace(c, speed=0.0) for c in body.coordinates))
