"""Common mistakes about rockets: bodies that lose mass as they burn fuel."""

from abc import abstractmethod
from collections.abc import Iterable
from dataclasses import replace

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism
from sim2reason.questions.study import Study
from sim2reason.scenes.dsl.mechanism import Burn, Mechanism

SLOWER = 1e-6  # factor on the rate of burning; the exhaust is faster by its inverse, so that the thrust stays


class BurningSlip(ChangedMechanism):
    """A common mistake about how one rocket burns its fuel."""

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return the bodies that burn fuel."""
        del query
        return [burn.body for burn in study.mechanism.burns]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with the mistake made for one rocket."""
        burns = tuple(self.burnt(mechanism, burn) if burn.body == subject else burn for burn in mechanism.burns)
        return replace(mechanism, burns=burns)

    @abstractmethod
    def burnt(self, mechanism: Mechanism, burn: Burn) -> Burn:
        """Return the burn of one rocket with the mistake made."""


def without_loss(burn: Burn) -> Burn:
    """Return a burn of the same thrust and duration that ejects almost no mass."""
    return replace(burn, rate=SLOWER * burn.rate, exhaust=burn.exhaust / SLOWER)
