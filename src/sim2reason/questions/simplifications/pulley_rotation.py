"""The rotation of a pulley is forgotten, though not its weight."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import NEARLY_NOTHING, with_bodies
from sim2reason.dsl.mechanism import Mechanism, RigidBody
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.hanging import carried
from sim2reason.questions.simplifications.parts.which import wheels
from sim2reason.questions.study import Study


@simplification
class PulleyRotationLeftOut(ChangedMechanism):
    """The rotational inertia of a pulley is left out; its mass is still lifted and accelerated."""

    name = "pulley rotation left out"
    reason = "the rotational inertia of {subject} is left out"
    common = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Each pulley whose mass alone matters too, and each of several.

        A single one with a fixed axle is covered by taking all pulleys as light.
        """
        del query
        mechanism = study.mechanism
        turning = [name for name in wheels(mechanism) if any(mechanism.body[name].inertia)]
        return [name for name in turning if len(turning) > 1 or carried(mechanism, name) is not None]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With next to no moment of inertia."""
        return with_bodies(mechanism, [subject], without_rotation)


def without_rotation(body: RigidBody) -> RigidBody:
    """A body of the same mass with next to no moment of inertia, so that no equation becomes singular."""
    xx, yy, zz, xy, xz, yz = (NEARLY_NOTHING * part for part in body.inertia)
    return replace(body, inertia=(xx, yy, zz, xy, xz, yz))
