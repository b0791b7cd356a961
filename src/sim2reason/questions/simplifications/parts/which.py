"""Parts of a mechanism to which misconceptions apply, and base class of simplified shapes."""

from collections.abc import Iterable
from dataclasses import replace
from math import isfinite
from typing import ClassVar

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import Misconception
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.ablation import with_bodies
from sim2reason.scenes.dsl.mechanism import Mechanism, RigidBody, SurfaceContact
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.solids import Overlooked, Shape, Solid, composed, transposed


def wheels(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the names of the wheels that strings turn."""
    turned = {wheel.coordinate for line in mechanism.lines if line.circle is None for wheel in line.wheels}
    return tuple(c.body for c in mechanism.coordinates if c.name in turned)


def massive(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the names of the bodies with mass, except wheels."""
    turned = wheels(mechanism)
    return tuple(body.name for body in mechanism.bodies if body.mass > 0.0 and body.name not in turned)


def others(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the bodies with mass that may affect others: all if more than one can move, else the fixed ones."""
    found = massive(mechanism)
    moving = [name for name in found if _can_move(mechanism, name)]
    return found if len(moving) > 1 else tuple(name for name in found if name not in moving)


def _can_move(mechanism: Mechanism, name: str | None) -> bool:
    if name is None:
        return False
    body = mechanism.body[name]
    return bool(body.coordinates) or _can_move(mechanism, body.parent)


def carriers(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the names of the bodies that can move and carry others, such as wedges and carts."""
    parents = {body.parent for body in mechanism.bodies} | {mechanism.site[name].body for name in _led(mechanism)}
    return tuple(body.name for body in mechanism.bodies if body.coordinates and body.mass and body.name in parents)


def _led(mechanism: Mechanism) -> set[str]:
    """Return the names of the points, such as those at pulleys, that lines pass between their two ends."""
    return {site for line in mechanism.lines for site in line.through[1:-1]}


def solid(mechanism: Mechanism) -> list[str]:
    """Return the names of the bodies with moment of inertia that can rotate."""
    return [name for name in massive(mechanism) if any(mechanism.body[name].inertia) and _turns(mechanism, name)]


def _turns(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body or its carrier has a hinge."""
    body = mechanism.body[name]
    if any(coordinate.kind == "hinge" for coordinate in body.coordinates):
        return True
    return body.parent is not None and _turns(mechanism, body.parent)


def rough(mechanism: Mechanism) -> list[SurfaceContact]:
    """Return the faces with finite friction on which a body can slip."""
    return [face for face in mechanism.faces if face.friction > 0.0 and isfinite(face.friction)]


class OtherFigure(Misconception):
    """The base class of misconceptions about the shape of one body, whose mass is kept.

    Class data:
        overlooked: the part of the shape that a solver overlooks.
    """

    overlooked: ClassVar[Overlooked]

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the bodies that can rotate and whose shape has the part that this misconception overlooks."""
        del query
        bodies = study.scene.bodies
        return [
            name
            for name in solid(study.mechanism)
            if isinstance(shape := bodies.get(name), Shape) and self.overlooked in shape.plainer
        ]

    def simplified(self, study: SimulatedScene, subject: str, until: float) -> SimulatedScene | None:
        """Return the motion with the moments of inertia of the simplified shape."""
        figure = _figure(study.scene, subject, self.overlooked)

        def change(mechanism: Mechanism) -> Mechanism:
            return with_bodies(mechanism, [subject], lambda body: self.taken_for(body, figure))

        return study.changed((self.name, subject), change, until)

    def taken_for(self, body: RigidBody, figure: Solid) -> RigidBody:
        """Return the body with the moments of inertia of a shape about its unchanged centre of mass."""
        return replace(body, inertia=figure.inertia(body.mass))


def _figure(scene: Scene, name: str, overlooked: Overlooked) -> Solid:
    """Return the simplified shape in its initial orientation about the body's centre."""
    shape = scene.bodies[name]
    assert isinstance(shape, Shape)
    axes = composed(transposed(shape.seen), scene.builder.turned[name])
    return shape.plainer[overlooked].turned(axes)
