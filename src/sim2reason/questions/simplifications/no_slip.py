"""What slips is taken to stick or roll."""

from collections.abc import Iterable
from dataclasses import replace
from math import inf, isfinite

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class NoSlip(ChangedMechanism):
    """What can turn on a rough face is taken to roll without slipping from the start."""

    name = "no slip"
    reason = "{subject} is taken to roll without slipping"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """What can roll, with a finite coefficient of friction."""
        del query
        faces = study.mechanism.faces
        return [
            face.subject for face in faces if len(face.slip) > 1 and face.friction > 0.0 and isfinite(face.friction)
        ]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With friction without bounds."""
        faces = (replace(face, friction=inf) if face.subject == subject else face for face in mechanism.faces)
        return replace(mechanism, faces=tuple(faces))
