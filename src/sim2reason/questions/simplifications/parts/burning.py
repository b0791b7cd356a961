"""Base class of misconceptions about rockets."""

from abc import abstractmethod
from collections.abc import Iterable
from dataclasses import replace

from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.mechanism import MassEjection, Mechanism

SLOWER = 1e-6  # factor on the burn rate; its inverse multiplies the exhaust speed, so that the thrust stays equal


class BurnMisconception(ChangedMechanism):
    """The base class of misconceptions about the burn of one rocket."""

    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the bodies that burn fuel."""
        del query
        return [burn.body for burn in study.mechanism.burns]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with the altered burn."""
        burns = tuple(self.burnt(mechanism, burn) if burn.body == subject else burn for burn in mechanism.burns)
        return replace(mechanism, burns=burns)

    @abstractmethod
    def burnt(self, mechanism: Mechanism, burn: MassEjection) -> MassEjection:
        """Return the burn of a rocket under the misconception."""


def without_loss(burn: MassEjection) -> MassEjection:
    """Return a burn of the same thrust and duration that ejects almost no mass."""
    return replace(burn, rate=SLOWER * burn.rate, exhaust=burn.exhaust / SLOWER)
