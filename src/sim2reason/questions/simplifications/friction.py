"""Misconceptions about friction and normal forces."""

from collections.abc import Iterable
from dataclasses import replace
from math import inf, isfinite

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, misconception
from sim2reason.questions.simplifications.parts.which import rough
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.ablation import weighs
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Mechanism


@misconception
class FaceFriction(ChangedMechanism):
    """The friction on one body is left out, but friction on other bodies is kept."""

    name = "friction on one body left out"
    reason = "the friction under {subject} is left out"
    common = True

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return each of several bodies on rough faces; none for a single one, which `NoFriction` covers."""
        del query
        found = [face.subject for face in rough(study.mechanism)]
        return found if len(found) > 1 else []

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


LEVEL = 1.0 - 1e-9  # cosine: steeper faces are slopes


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
        return [""] if weighs(mechanism) and _sloped(mechanism) else []

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
    sloped = [face for face in rough(mechanism) if not face.turning]
    if not sloped:
        return {}
    frames = initial_frames(mechanism)
    found = {face.subject: float(frames.normal(face.subject)[2]) for face in sloped}
    return {name: cosine for name, cosine in found.items() if 0.0 < cosine < LEVEL}
