"""Mistakes about friction and normal forces."""

from collections.abc import Iterable
from dataclasses import replace
from math import inf, isfinite

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.which import rough
from sim2reason.questions.study import Study
from sim2reason.scenes.dsl.ablation import weighs
from sim2reason.scenes.dsl.frames import start
from sim2reason.scenes.dsl.mechanism import Mechanism


@simplification
class FaceFriction(ChangedMechanism):
    """The friction on one body is left out, but that on others is kept."""

    name = "friction on one body left out"
    reason = "the friction under {subject} is left out"
    common = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Each of several bodies that lie on rough faces; a single one is covered by leaving out all friction."""
        del query
        found = [face.subject for face in rough(study.mechanism)]
        return found if len(found) > 1 else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with that face smooth."""
        faces = (replace(face, friction=0.0) if face.subject == subject else face for face in mechanism.faces)
        return replace(mechanism, faces=tuple(faces))


@simplification
class NoFriction(ChangedMechanism):
    """All faces are taken as smooth, so that what rolls slides without turning."""

    name = "no friction"
    common = True
    reason = "friction is left out"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return the whole, where a face is rough."""
        del query
        return [""] if any(face.friction for face in study.mechanism.faces) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with all coefficients zero."""
        del subject
        return replace(mechanism, faces=tuple(replace(face, friction=0.0) for face in mechanism.faces))


@simplification
class NoSlip(ChangedMechanism):
    """What can turn on a rough face is taken to roll without slipping from the start."""

    name = "no slip"
    reason = "{subject} is taken to roll without slipping"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return what can roll, with a finite coefficient of friction."""
        del query
        faces = study.mechanism.faces
        return [
            face.subject for face in faces if len(face.slip) > 1 and face.friction > 0.0 and isfinite(face.friction)
        ]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with friction without bounds."""
        faces = (replace(face, friction=inf) if face.subject == subject else face for face in mechanism.faces)
        return replace(mechanism, faces=tuple(faces))


LEVEL = 1.0 - 1e-9  # cosine of a slope that is none


@simplification
class WeightAsNormalForce(ChangedMechanism):
    """Friction on a slope is taken to be µ m g, without the cosine."""

    name = "weight as normal force"
    reason = "the normal force that friction hangs on is taken to be the whole weight, though the face is sloped"
    sound_if_same = True  # then what lies there does not slip
    common = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return the whole, where a slope is rough."""
        del query
        mechanism = study.mechanism
        return [""] if weighs(mechanism) and _sloped(mechanism) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With coefficients that are larger by as much as the normal force is less than the weight."""
        del subject
        sloped = _sloped(mechanism)
        faces = (
            replace(face, friction=face.friction / sloped[face.subject]) if face.subject in sloped else face
            for face in mechanism.faces
        )
        return replace(mechanism, faces=tuple(faces))


def _sloped(mechanism: Mechanism) -> dict[str, float]:
    """Return the cosine of the slope by what lies on one that is rough."""
    sloped = [face for face in rough(mechanism) if not face.turning]
    if not sloped:
        return {}
    frames = start(mechanism)
    found = {face.subject: float(frames.normal(face.subject)[2]) for face in sloped}
    return {name: cosine for name, cosine in found.items() if 0.0 < cosine < LEVEL}
