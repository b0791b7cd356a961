"""How high a body gets."""

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Displacement
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.moments.highest_point import HighestPoint
from sim2reason.questions.words import Words


@functional
class GreatestHeight(Extreme):
    """The greatest height of a body above its starting point."""

    name = "greatest height"
    quantity = Displacement
    phrase = "the greatest height of {body} above its starting point"
    how = "how high above its starting point does {body} get {when}?"
    weight = 2.0

    def height(self, state: State, name: str) -> Array:
        """The vertical displacement, (n,)."""
        return Displacement.evaluate(state, name)[:, 2]

    def present(self, words: Words, name: str) -> bool:
        """What flies or swings."""
        return name in HighestPoint.candidates(words)
