"""Momentum: where nothing outside pulls along a direction, momentum is kept; energy gives the relative motion."""

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.solutions.oscillations.pair_way import PairWay
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.strategies import strategy
from sim2reason.solutions.strategies.energy import EnergyWay, WorkAndEnergy
from sim2reason.solutions.writing.steps import Book


@strategy
class MomentumKept(WorkAndEnergy):
    """Two free coordinates, one of them along a direction of which nothing pulls."""

    name = "momentum"
    cost = 0.95
    kinds = frozenset({"event", "extremum"})
    free = 2

    def unfit(self, mechanism: Mechanism) -> str:
        """Return why it applies to nothing: as for energy, or a single body moves."""
        alone = len({coordinate.body for coordinate in mechanism.coordinates}) < self.free
        return "a single body moves" if alone else super().unfit(mechanism)

    def write(self, setting: Setting, book: Book) -> str:
        """The reduced mass, the work, what momentum says, then what is asked."""
        return _Pair(setting, book).write().name


class _Pair(PairWay, EnergyWay):
    """The relative motion by energy."""
