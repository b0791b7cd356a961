"""Misconceptions that ignore or alter forces: those of fields, springs, hands, friction and other bodies."""

from collections.abc import Iterable
from dataclasses import replace
from math import inf, isfinite

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, FixedBody, misconception
from sim2reason.questions.simplifications.inertia import (
    influential_bodies,
    massive_bodies,
    movable_carriers,
    rough_faces,
)
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import ConstantTension, Elastic, Line, Mechanism, RigidBody
from sim2reason.scenes.dsl.structure import (
    RESIDUAL_MASS_RATIO,
    is_gravity_relevant,
    remove_body,
    replace_bodies,
    replace_lines,
    rotating_line,
)
from sim2reason.scenes.dsl.vectors import scale


@misconception
class BodyHeld(FixedBody):
    """A moving body is assumed to be fixed."""

    name = "body held"
    reason = "{subject} is taken to stay where it is"
    part = True
    misleads = False

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the bodies that can move, except wheels."""
        del query
        movable = {coordinate.body for coordinate in study.mechanism.coordinates}
        return [name for name in massive_bodies(study.mechanism) if name in movable]


@misconception
class BodyLeftOut(ChangedMechanism):
    """A body is ignored: it has no mass, and nothing collides with it."""

    name = "body left out"
    reason = "all is taken to move as if {subject} were not there"
    part = True
    misleads = False

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the bodies with mass, if several; except those on springs, across strings or at pivots."""
        del query
        mechanism = study.mechanism
        elastic = [line for line in mechanism.lines if isinstance(line.law, Elastic)]
        sprung = {mechanism.site[site].body for line in elastic for site in line.through}
        sprung |= {body for line in elastic for body in line.circle or ()}
        frames = initial_frames(mechanism)
        turning = [line for line in mechanism.lines if rotating_line(line, frames)]
        end_bodies = {mechanism.site[site].body for line in turning for site in (line.through[0], line.through[-1])}
        pivots = {body.parent for body in mechanism.bodies if any(c.kind == "hinge" for c in body.coordinates)}
        return [name for name in influential_bodies(mechanism) if name not in sprung | end_bodies | pivots]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism without the body's mass, inertia and collisions."""
        return remove_body(mechanism, subject)


@misconception
class FixedCarrier(FixedBody):
    """A carrier of other bodies, such as a wedge, is assumed to be fixed."""

    name = "fixed carrier"
    reason = "{subject} is taken as fixed"
    holds = True
    common = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the carriers that can move."""
        del query
        return movable_carriers(study.mechanism)


@misconception
class ForceLeftOut(ChangedMechanism):
    """The force of a field, or the drag of a medium, is ignored."""

    name = "force left out"
    reason = "the force of {subject} is left out"
    part = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the names of the forces of fields and resisting media."""
        del query
        return [force.name for force in study.mechanism.forces]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism without the force."""
        return replace(mechanism, forces=tuple(force for force in mechanism.forces if force.name != subject))


@misconception
class FromRest(ChangedMechanism):
    """Bodies with initial velocities are assumed to start from rest."""

    name = "from rest"
    common = True
    reason = "the velocity at the start is left out"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a body moves at the start; none for planets."""
        del query
        moving = any(coordinate.speed for coordinate in study.mechanism.coordinates)
        return [""] if moving and not study.mechanism.attractions else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with all initial velocities zero."""
        del subject
        return replace_bodies(mechanism, mechanism.body, _still)


def _still(body: RigidBody) -> RigidBody:
    return replace(body, coordinates=tuple(replace(c, speed=0.0) for c in body.coordinates))


@misconception
class GravityLeftOut(ChangedMechanism):
    """Gravity is ignored."""

    name = "gravity left out"
    reason = "weight is left out"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if gravity acts on a body; else none."""
        del query
        return [""] if is_gravity_relevant(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with negligible gravity, which still defines a vertical direction."""
        del subject
        return replace(mechanism, gravity=scale(RESIDUAL_MASS_RATIO, mechanism.gravity))


@misconception
class HandLeftOut(ChangedMechanism):
    """The pull of a hand on a string is ignored."""

    name = "hand left out"
    reason = "the pull of the hand is left out"
    part = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the names of the strings drawn in by a hand."""
        del query
        return [line.name for line in study.mechanism.pulls]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with zero pull on the string."""
        return replace_lines(mechanism, [subject], lambda line: replace(line, law=ConstantTension(0.0)))


@misconception
class NoDamping(ChangedMechanism):
    """All dashpots are ignored."""

    name = "no damping"
    reason = "damping is left out"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a spring is damped; else none."""
        del query
        return [""] if _damped(study.mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with undamped springs."""
        del subject
        return replace_lines(mechanism, _damped(mechanism), _undamped)


def _damped(mechanism: Mechanism) -> list[str]:
    return [line.name for line in mechanism.lines if isinstance(line.law, Elastic) and line.law.damping]


def _undamped(line: Line) -> Line:
    assert isinstance(line.law, Elastic)
    return replace(line, law=replace(line.law, damping=0.0))


@misconception
class SpringLeftOut(ChangedMechanism):
    """A spring is ignored, together with its stored energy."""

    name = "spring left out"
    reason = "{subject} is left out"
    part = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the names of all springs."""
        del query
        return [line.name for line in study.mechanism.lines if isinstance(line.law, Elastic)]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with a spring that exerts no force."""
        return replace_lines(mechanism, [subject], lambda line: replace(line, law=Elastic(0.0, 0.0)))


@misconception
class FaceFriction(ChangedMechanism):
    """The friction on one body is left out, but friction on other bodies is kept."""

    name = "friction on one body left out"
    reason = "the friction under {subject} is left out"
    common = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return each of several bodies on rough faces; none for a single one, which `NoFriction` covers."""
        del query
        bodies = [face.subject for face in rough_faces(study.mechanism)]
        return bodies if len(bodies) > 1 else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with the body's face smooth."""
        faces = (replace(face, friction=0.0) if face.subject == subject else face for face in mechanism.faces)
        return replace(mechanism, faces=tuple(faces))


@misconception
class NoFriction(ChangedMechanism):
    """All faces are assumed to be smooth, so that rolling bodies slide without rotation."""

    name = "no friction"
    common = True
    reason = "friction is left out"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a face is rough; else none."""
        del query
        return [""] if any(face.friction for face in study.mechanism.faces) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with all coefficients of friction zero."""
        del subject
        return replace(mechanism, faces=tuple(replace(face, friction=0.0) for face in mechanism.faces))


@misconception
class NoSlip(ChangedMechanism):
    """A body that can rotate on a rough face is assumed to roll without slipping from the start."""

    name = "no slip"
    reason = "{subject} is taken to roll without slipping"

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the bodies that can roll on faces with finite friction."""
        del query
        faces = study.mechanism.faces
        return [
            face.subject for face in faces if len(face.slip) > 1 and face.friction > 0.0 and isfinite(face.friction)
        ]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with unlimited friction on the body's face."""
        faces = (replace(face, friction=inf) if face.subject == subject else face for face in mechanism.faces)
        return replace(mechanism, faces=tuple(faces))


LEVEL_COSINE = 1.0 - 1e-9  # cosine: steeper faces are slopes


@misconception
class WeightAsNormalForce(ChangedMechanism):
    """Friction on a slope is taken to be µ m g, without the cosine."""

    name = "weight as normal force"
    reason = "the normal force that friction hangs on is taken to be the whole weight, though the face is sloped"
    sound_if_same = True  # then what lies there does not slip
    common = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the whole mechanism as the subject if a slope is rough; else none."""
        del query
        mechanism = study.mechanism
        return [""] if is_gravity_relevant(mechanism) and _sloped(mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with coefficients of friction divided by the cosines of the slopes."""
        del subject
        sloped = _sloped(mechanism)
        faces = (
            replace(face, friction=face.friction / sloped[face.subject]) if face.subject in sloped else face
            for face in mechanism.faces
        )
        return replace(mechanism, faces=tuple(faces))


def _sloped(mechanism: Mechanism) -> dict[str, float]:
    """Return the cosine of the slope for each body on a rough slope."""
    sloped = [face for face in rough_faces(mechanism) if not face.turning]
    if not sloped:
        return {}
    frames = initial_frames(mechanism)
    cosines = {face.subject: float(frames.normal(face.subject)[2]) for face in sloped}
    return {name: cosine for name, cosine in cosines.items() if 0.0 < cosine < LEVEL_COSINE}
