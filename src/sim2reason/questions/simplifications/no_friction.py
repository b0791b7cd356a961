"""Friction is left out."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study


@simplification
class NoFriction(ChangedMechanism):
    """All faces are taken as smooth, so that what rolls slides without turning."""

    name = "no friction"
    common = True
    reason = "friction is left out"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """The whole, where a face is rough."""
        del query
        return [""] if any(face.friction for face in study.mechanism.faces) else []

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With all coefficients zero."""
        del subject
        return replace(mechanism, faces=tuple(replace(face, friction=0.0) for face in mechanism.faces))
