"""How far a body gets from its starting point."""

from sim2reason.quantities.kinematics import Displacement
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.circles import circles
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.words import Words


@functional
class GreatestDisplacement(Extreme):
    """The greatest distance of a body from its starting point."""

    name = "greatest displacement"
    quantity = Displacement
    phrase = "the greatest distance between {body} and its starting point{ground}"
    weight = 1.0

    def present(self, words: Words, name: str) -> bool:
        """Not on a circle, where the other end of the swing tells it."""
        return not circles(words.mechanism, name)
