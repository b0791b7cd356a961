"""The parallel-axis theorem is forgotten."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.ablation import with_bodies
from sim2reason.dsl.mechanism import Mechanism, RigidBody
from sim2reason.dsl.vectors import Vector, add, inner, scale
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.which import solid
from sim2reason.questions.study import Study

ON_AXIS = 1e-9  # m


@simplification
class ParallelAxisForgotten(ChangedMechanism):
    """The moment of inertia about the axle is taken to be that about the centre of mass."""

    name = "parallel axis forgotten"
    reason = "the parallel-axis theorem is not applied"
    common = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where something with a size turns about an axis beside its centre of mass that nothing moves."""
        del query
        return [""] if _off_axis(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With moments of inertia less by m(d² 1 - d dᵀ), which motion about the axle adds again."""
        del subject
        arms = _off_axis(mechanism)

        def less(body: RigidBody) -> RigidBody:
            x, y, z = arms[body.name]
            steiner = (y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z)
            xx, yy, zz, xy, xz, yz = (i - body.mass * part for i, part in zip(body.inertia, steiner, strict=True))
            return replace(body, inertia=(xx, yy, zz, xy, xz, yz))

        return with_bodies(mechanism, arms, less)


def _off_axis(mechanism: Mechanism) -> dict[str, Vector]:
    """The arms from such axes to centres of mass, at right angles to the axes, m; by body."""
    arms = ((name, _arm(mechanism, name)) for name in solid(mechanism))
    return {name: arm for name, arm in arms if arm is not None and inner(arm, arm) > ON_AXIS**2}


def _arm(mechanism: Mechanism, name: str) -> Vector | None:
    body = mechanism.body[name]
    arm = body.center
    while not body.coordinates and body.parent is not None:
        arm, body = add(body.at, arm), mechanism.body[body.parent]
    hinges = [coordinate for coordinate in body.coordinates if coordinate.kind == "hinge"]
    if len(hinges) != 1 or body.parent is not None:
        return None
    axis = hinges[0].axis
    return add(arm, scale(-inner(arm, axis), axis))
