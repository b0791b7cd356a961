"""Slips that take a body for a simpler figure."""

from collections.abc import Iterable
from dataclasses import replace
from typing import ClassVar

from sim2reason.dsl.ablation import with_bodies
from sim2reason.dsl.mechanism import Mechanism, RigidBody
from sim2reason.dsl.scene import Scene
from sim2reason.dsl.solids import Overlooked, Shape, Solid, composed, transposed
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import Simplification
from sim2reason.questions.simplifications.parts.which import solid
from sim2reason.questions.study import Study


class OtherFigure(Simplification):
    """A slip about the figure of one body; its mass stays.

    Class data:
        overlooked: what of its figure a reader does not think of.
    """

    overlooked: ClassVar[Overlooked]

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """What can turn and may be taken for such a figure."""
        del query
        bodies = study.scene.bodies
        return [
            name
            for name in solid(study.mechanism)
            if isinstance(shape := bodies.get(name), Shape) and self.overlooked in shape.plainer
        ]

    def simplified(self, study: Study, subject: str, until: float) -> Study | None:
        """The motion with the inertia of that figure."""
        figure = _figure(study.scene, subject, self.overlooked)

        def change(mechanism: Mechanism) -> Mechanism:
            return with_bodies(mechanism, [subject], lambda body: self.taken_for(body, figure))

        return study.changed((self.name, subject), change, until)

    def taken_for(self, body: RigidBody, figure: Solid) -> RigidBody:
        """The body with the moments of inertia of a figure about its centre of mass, which stays where it is."""
        return replace(body, inertia=figure.inertia(body.mass))


def _figure(scene: Scene, name: str, overlooked: Overlooked) -> Solid:
    """The simpler figure as it is turned at the start, about what the text calls the centre of the body."""
    shape = scene.bodies[name]
    assert isinstance(shape, Shape)
    axes = composed(transposed(shape.seen), scene.builder.turned[name])
    return shape.plainer[overlooked].turned(axes)
