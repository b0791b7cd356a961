"""The greatest and least coordinates of a body, and distances from the origin; never drawn by recipes."""

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.coordinates import OriginDistance, XCoordinate, YCoordinate
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


@functional
class GreatestOriginDistance(ExtremeCoordinate):
    """The greatest distance of a body from the origin."""

    name = "greatest distance from the origin"
    quantity = OriginDistance
    phrase = "the greatest distance of {body} from the origin"


@functional
class LeastOriginDistance(ExtremeCoordinate):
    """The least distance of a body from the origin."""

    name = "least distance from the origin"
    quantity = OriginDistance
    sign = -1.0
    phrase = "the least distance of {body} from the origin"
