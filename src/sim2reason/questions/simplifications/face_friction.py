"""Friction is forgotten on one of several rough faces."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.which import rough
from sim2reason.questions.study import Study


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
        """With that face smooth."""
        faces = (replace(face, friction=0.0) if face.subject == subject else face for face in mechanism.faces)
        return replace(mechanism, faces=tuple(faces))
