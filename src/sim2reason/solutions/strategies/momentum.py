"""Momentum: where nothing outside pulls along a direction, momentum is kept; energy gives the relative motion."""

from sim2reason.solutions.book import Book
from sim2reason.solutions.expressions import Symbol
from sim2reason.solutions.pair_way import PairWay
from sim2reason.solutions.polynomials import Polynomial
from sim2reason.solutions.setting import Setting
from sim2reason.solutions.strategies import strategy
from sim2reason.solutions.strategies.energy import WorkAndEnergy, Working


@strategy
class MomentumKept(WorkAndEnergy):
    """Two free coordinates, one of them along a direction of which nothing pulls."""

    name = "momentum"
    cost = 0.95
    kinds = frozenset({"event", "extremum"})

    def write(self, setting: Setting, book: Book) -> str:
        """The reduced mass, the work, what momentum says, then what is asked."""
        return _Pair(setting, book).write().name


class _Pair(PairWay, Working):
    """The relative motion by energy."""

    def called(self) -> Symbol:
        """The name of how far the relative motion has come."""
        return self.name

    def clock(self) -> Symbol:
        """The time of the moment."""
        return Working.clock(self)

    def relative(self, kind: str) -> Polynomial:
        """Of the relative motion."""
        return self.along(kind)
