"""Strings and what they carry; a string that massive pulleys cut has these for each part."""

from sim2reason.dsl.state import Array, State
from sim2reason.quantities import Quantity, quantity
from sim2reason.quantities.subjects.strings import Strings


@quantity
class StringLength(Quantity):
    """The change since the start of the length of the free part, site to site.

    What a massive pulley winds on or off changes it. A slack string counts as the shortest line.
    """

    name, unit, symbol = "length", "m", "l"
    of = Strings()
    floor = 0.1

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """Δl, (n,)."""
        line = state.mechanism.line[subject]
        return state.length(line)[0] - state.began.length(line)


@quantity
class StringLengthRate(Quantity):
    """The rate at which the free part grows."""

    name, unit, symbol = "rate of change of length", "m/s", "u"
    of = Strings()
    floor, least = 0.1, 1e-2

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """dl/dt, (n,)."""
        return state.length(state.mechanism.line[subject])[1]


@quantity
class Tension(Quantity):
    """The tension of a string: 0 where it is slack, NaN where the mechanism does not determine it."""

    name, unit, symbol = "tension", "N", "T"
    of = Strings()
    magnitude = "the tension in {string}"
    needs = ("mass",)
    immediate = True
    weight = 3.0
    floor, heavy = 0.1, True
    panel, order = "tension", 0

    @staticmethod
    def evaluate(state: State, subject: str) -> Array:
        """T ≥ 0, (n,)."""
        return state.tension[subject]
