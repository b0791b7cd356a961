"""Slips about what burns fuel."""

from abc import abstractmethod
from collections.abc import Iterable
from dataclasses import replace

from sim2reason.dsl.mechanism import Burn, Mechanism
from sim2reason.questions.query import Query
from sim2reason.questions.simplifications import ChangedMechanism
from sim2reason.questions.study import Study

SLOWER = 1e-6  # how much less mass is ejected, so much faster: the thrust stays


class BurningSlip(ChangedMechanism):
    """A slip about the way in which one body burns its fuel."""

    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return what burns."""
        del query
        return [burn.body for burn in study.mechanism.burns]

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism in which that body burns as the slip has it."""
        burns = tuple(self.burnt(mechanism, burn) if burn.body == subject else burn for burn in mechanism.burns)
        return replace(mechanism, burns=burns)

    @abstractmethod
    def burnt(self, mechanism: Mechanism, burn: Burn) -> Burn:
        """Return the way in which it burns as the slip has it."""


def without_loss(burn: Burn) -> Burn:
    """Return the same thrust for the same time from next to no mass."""
    return replace(burn, rate=SLOWER * burn.rate, exhaust=burn.exhaust / SLOWER)
