"""The greatest and least coordinates of a body on the axes of the text; never drawn by recipes."""

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.coordinates import XCoordinate, YCoordinate
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace


class ExtremeCoordinate(Extreme):
    """An extreme of a coordinate, which has a sign."""

    drawn_by_recipes = False

    def height(self, state: State, name: str) -> Array:
        """Return the coordinate, of the least value with a minus sign, (n,)."""
        return self.sign * self.quantity.evaluate(state, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the extreme coordinate in m, wherever in the stretch it is."""
        return self.between(trace, name, 0.0, end)

    def present(self, words: Words, name: str) -> bool:
        """Return whether the text states the coordinate at the start."""
        return self.quantity().fits(words.mechanism, name)


@functional
class GreatestXCoordinate(ExtremeCoordinate):
    """The greatest x coordinate of a body."""

    name = "greatest x coordinate"
    quantity = XCoordinate
    phrase = "the greatest x coordinate of {body}"


@functional
class LeastXCoordinate(ExtremeCoordinate):
    """The least x coordinate of a body."""

    name = "least x coordinate"
    quantity = XCoordinate
    sign = -1.0
    phrase = "the least x coordinate of {body}"


@functional
class GreatestYCoordinate(ExtremeCoordinate):
    """The greatest y coordinate of a body."""

    name = "greatest y coordinate"
    quantity = YCoordinate
    phrase = "the greatest y coordinate of {body}"


@functional
class LeastYCoordinate(ExtremeCoordinate):
    """The least y coordinate of a body."""

    name = "least y coordinate"
    quantity = YCoordinate
    sign = -1.0
    phrase = "the least y coordinate of {body}"
