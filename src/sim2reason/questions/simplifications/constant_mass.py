"""What burns fuel is taken to keep its mass."""

from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.mechanism import Burn, Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism, simplification
from sim2reason.questions.study import Study

SLOWER = 1e-6  # how much less mass is ejected, so much faster: the thrust stays


@simplification
class ConstantMass(ChangedMechanism):
    """What burns fuel is taken to keep its mass."""

    name = "constant mass"
    reason = "the mass of {subject} is taken as constant"

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """What burns."""
        del query
        return [burn.body for burn in study.mechanism.burns]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """With the same thrust from next to no mass."""
        burns = tuple(_steady(burn) if burn.body == subject else burn for burn in mechanism.burns)
        return replace(mechanism, burns=burns)


def _steady(burn: Burn) -> Burn:
    return replace(burn, rate=SLOWER * burn.rate, exhaust=burn.exhaust / SLOWER)
