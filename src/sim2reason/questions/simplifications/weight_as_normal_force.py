"""The normal force on a slope is taken to be the weight."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.frames import start
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.dsl.mobility import weighs
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.which import rough
from sim2reason.questions.study import Study

LEVEL = 1.0 - 1e-9  # cosine of a slope that is none


@simplification
class WeightAsNormalForce(ChangedMechanism):
    """Friction on a slope is taken to be µ m g, without the cosine."""

    name = "weight as normal force"
    reason = "the normal force that friction hangs on is taken to be the whole weight, though the face is sloped"
    sound_if_same = True  # then what lies there does not slip
    common = True

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where a slope is rough."""
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
    """The cosine of the slope by what lies on one that is rough."""
    sloped = [face for face in rough(mechanism) if not face.turning]
    if not sloped:
        return {}
    frames = start(mechanism)
    found = {face.subject: float(frames.normal(face.subject)[2]) for face in sloped}
    return {name: cosine for name, cosine in found.items() if 0.0 < cosine < LEVEL}
