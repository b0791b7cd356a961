"""Misconceptions about moments of inertia and centres of mass, and parts of a mechanism to which they apply."""

from collections.abc import Iterable
from dataclasses import replace
from math import isfinite
from typing import ClassVar

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, Misconception, misconception
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.mechanism import ZERO, Mechanism, RigidBody, SurfaceContact
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.solids import Overlooked, Shape, Solid, compose_axes, transposed
from sim2reason.scenes.dsl.structure import as_point_mass, replace_bodies
from sim2reason.scenes.dsl.vectors import Vector, add, inner, scale


def string_wheels(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the names of the wheels that strings turn."""
    turned = {wheel.coordinate for line in mechanism.lines if line.circle is None for wheel in line.wheels}
    return tuple(c.body for c in mechanism.coordinates if c.name in turned)


def massive_bodies(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the names of the bodies with mass, except wheels."""
    turned = string_wheels(mechanism)
    return tuple(body.name for body in mechanism.bodies if body.mass > 0.0 and body.name not in turned)


def influential_bodies(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the bodies with mass that may affect others: all if more than one can move, else the fixed ones."""
    bodies = massive_bodies(mechanism)
    moving = [name for name in bodies if _can_move(mechanism, name)]
    return bodies if len(moving) > 1 else tuple(name for name in bodies if name not in moving)


def _can_move(mechanism: Mechanism, name: str | None) -> bool:
    if name is None:
        return False
    body = mechanism.body[name]
    return bool(body.coordinates) or _can_move(mechanism, body.parent)


def movable_carriers(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the names of the bodies that can move and carry others, such as wedges and carts."""
    parents = {body.parent for body in mechanism.bodies} | {mechanism.site[name].body for name in _led(mechanism)}
    return tuple(body.name for body in mechanism.bodies if body.coordinates and body.mass and body.name in parents)


def _led(mechanism: Mechanism) -> set[str]:
    """Return the names of the points, such as those at pulleys, that lines pass between their two ends."""
    return {site for line in mechanism.lines for site in line.through[1:-1]}


def rotatable_bodies(mechanism: Mechanism) -> list[str]:
    """Return the names of the bodies with moment of inertia that can rotate."""
    return [name for name in massive_bodies(mechanism) if any(mechanism.body[name].inertia) and _turns(mechanism, name)]


def _turns(mechanism: Mechanism, name: str) -> bool:
    """Return whether a body or its carrier has a hinge."""
    body = mechanism.body[name]
    if any(coordinate.kind == "hinge" for coordinate in body.coordinates):
        return True
    return body.parent is not None and _turns(mechanism, body.parent)


def rough_faces(mechanism: Mechanism) -> list[SurfaceContact]:
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
            for name in rotatable_bodies(study.mechanism)
            if isinstance(shape := bodies.get(name), Shape) and self.overlooked in shape.plainer
        ]

    def simplified(self, study: SimulatedScene, subject: str, until: float) -> SimulatedScene | None:
        """Return the motion with the moments of inertia of the simplified shape."""
        figure = _figure(study.scene, subject, self.overlooked)

        def change(mechanism: Mechanism) -> Mechanism:
            return replace_bodies(mechanism, [subject], lambda body: self.taken_for(body, figure))

        return study.changed((self.name, subject), change, until)

    def taken_for(self, body: RigidBody, figure: Solid) -> RigidBody:
        """Return the body with the moments of inertia of a shape about its unchanged centre of mass."""
        return replace(body, inertia=figure.inertia(body.mass))


def _figure(scene: Scene, name: str, overlooked: Overlooked) -> Solid:
    """Return the simplified shape in its initial orientation about the body's centre."""
    shape = scene.bodies[name]
    assert isinstance(shape, Shape)
    axes = compose_axes(transposed(shape.seen), scene.builder.turned[name])
    return shape.plainer[overlooked].turned(axes)


@misconception
class CenterOfMass(ChangedMechanism):
    """A body's centre of mass is taken to be its geometric centre, such as that of a hemisphere's flat face."""

    name = "centre of mass not displaced"
    reason = "the centre of mass of {subject} is taken to be at its geometric centre"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the bodies that can rotate and whose centre of mass is not their centre."""
        del query
        mechanism = study.mechanism
        return [name for name in rotatable_bodies(mechanism) if any(mechanism.body[name].center)]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with the body's centre of mass at its centre."""
        return replace_bodies(mechanism, [subject], lambda body: replace(body, center=ZERO))


@misconception
class HoleAboutCenter(OtherFigure):
    """The moment of inertia about the geometric centre is taken to be that of the body without the hole.

    The one about the centre of mass then follows by the parallel-axis theorem.
    """

    name = "hole left out of the inertia about the centre"
    reason = "the moment of inertia of {subject} about its geometric centre is taken to be that without the hole"
    overlooked = "hole"

    def taken_for(self, body: RigidBody, figure: Solid) -> RigidBody:
        """Return the body with the inertia of a solid without hole about the geometric centre, less m(c² 1 − c cᵀ)."""
        x, y, z = body.center
        about = figure.inertia(body.mass)
        steiner = (y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z)
        xx, yy, zz, xy, xz, yz = (a - body.mass * b for a, b in zip(about, steiner, strict=True))
        return replace(body, inertia=(xx, yy, zz, xy, xz, yz))


@misconception
class HoleForgotten(OtherFigure):
    """The hole of a body is ignored, so that its centre of mass is at its centre."""

    name = "hole left out"
    reason = "the hole in {subject} is left out"
    overlooked = "hole"

    def taken_for(self, body: RigidBody, figure: Solid) -> RigidBody:
        """Return the body with the inertia and the centre of mass of a solid of the same mass without a hole."""
        return replace(body, center=figure.center, inertia=figure.inertia(body.mass))


@misconception
class HoleInInertia(OtherFigure):
    """The moment of inertia about the centre of mass is taken to be that of the body without the hole."""

    name = "hole left out of the inertia"
    reason = "the moment of inertia of {subject} about its centre of mass is taken to be that without the hole"
    overlooked = "hole"
    common = True


@misconception
class OwnInertia(ChangedMechanism):
    """The moment of inertia of one body about its centre of mass is left out, but that of others is kept."""

    name = "own inertia left out"
    common = True
    reason = "the moment of inertia of {subject} about its own centre of mass is left out"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return each of several bodies; none for a single one, which `PointMass` covers."""
        del query
        bodies = rotatable_bodies(study.mechanism)
        return bodies if len(bodies) > 1 else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism without the body's moment of inertia."""
        return replace_bodies(mechanism, [subject], as_point_mass)


ON_AXIS_DISTANCE = 1e-9  # m


@misconception
class ParallelAxisForgotten(ChangedMechanism):
    """The moment of inertia about the axle is taken to be that about the centre of mass."""

    name = "parallel axis forgotten"
    reason = "the parallel-axis theorem is not applied"
    common = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a body turns about a fixed off-centre axis; else none."""
        del query
        return [""] if _off_axis(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with inertia tensors reduced by m(d² 1 − d dᵀ), which motion about the axle restores."""
        del subject
        arms = _off_axis(mechanism)

        def less(body: RigidBody) -> RigidBody:
            x, y, z = arms[body.name]
            steiner = (y * y + z * z, x * x + z * z, x * x + y * y, -x * y, -x * z, -y * z)
            xx, yy, zz, xy, xz, yz = (i - body.mass * part for i, part in zip(body.inertia, steiner, strict=True))
            return replace(body, inertia=(xx, yy, zz, xy, xz, yz))

        return replace_bodies(mechanism, arms, less)


def _off_axis(mechanism: Mechanism) -> dict[str, Vector]:
    """Return the perpendicular vectors, m, from fixed axes of rotation to centres of mass off the axes, by body."""
    arms = ((name, _arm(mechanism, name)) for name in rotatable_bodies(mechanism))
    return {name: arm for name, arm in arms if arm is not None and inner(arm, arm) > ON_AXIS_DISTANCE**2}


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


@misconception
class PointMass(ChangedMechanism):
    """Extended bodies are treated as points at their centres of mass, so that rolling bodies only slide."""

    name = "point mass"
    reason = "the moment of inertia about the centre of mass is left out"
    common = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a body with moment of inertia can rotate; else none."""
        del query
        return [""] if rotatable_bodies(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism without moments of inertia about centres of mass."""
        del subject
        return replace_bodies(mechanism, rotatable_bodies(mechanism), as_point_mass)


@misconception
class ThinDisc(OtherFigure):
    """The moment of inertia is taken to be that of a thin disc of the same radius."""

    name = "body taken as a thin disc"
    reason = "the moment of inertia of {subject} is taken to be that of a thin disc"
    overlooked = "height"
    common = True


@misconception
class ThinRod(OtherFigure):
    """The moment of inertia is taken to be that of a thin rod of the same length."""

    name = "body taken as a thin rod"
    reason = "the moment of inertia of {subject} is taken to be that of a thin rod"
    overlooked = "section"


@misconception
class ThinWall(OtherFigure):
    """The moment of inertia is taken to be that of a thin shell or pipe of the same radius."""

    name = "wall taken as thin"
    reason = "the wall of {subject} is taken as thin"
    overlooked = "wall"
