"""A body that moves is held where it is."""

from collections.abc import Iterable

from sim2reason.dsl.ablation import held
from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.simplifications.parts.which import massive
from sim2reason.questions.study import Study


@simplification
class BodyHeld(ChangedMechanism):
    """A body that moves is held where it is."""

    name = "body held"
    reason = "{subject} is taken to stay where it is"
    part = True
    misleads = False

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """All that can move but for wheels."""
        del query
        movable = {coordinate.body for coordinate in study.mechanism.coordinates}
        return [name for name in massive(study.mechanism) if name in movable]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With it held on what carries it."""
        return held(mechanism, subject)
