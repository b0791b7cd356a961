"""How high a body gets."""

from sim2reason.quantities.kinematics import Displacement
from sim2reason.quantities.subjects import Sense
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.questions.moments.highest_point import HighestPoint
from sim2reason.questions.words import Words

UPWARD = Sense("upward", (0.0, 0.0, 1.0), fixed=True)


@functional
class GreatestHeight(Extreme):
    """The greatest height of a body above its starting point."""

    name = "greatest height"
    quantity, sense = Displacement, UPWARD
    phrase = "the greatest height of {body} above its starting point"
    how = "how high above its starting point does {body} get {when}?"
    weight = 2.0

    def present(self, words: Words, name: str) -> bool:
        """What flies or swings."""
        return name in HighestPoint.candidates(words)
