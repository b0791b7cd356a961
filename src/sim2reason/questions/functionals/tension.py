"""The greatest and the least tension of a string."""

from sim2reason.quantities.tension import Tension
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestTension(Extreme):
    """The greatest tension in a string."""

    name = "greatest tension"
    quantity = Tension
    impulsive = True
    phrase = "the greatest tension in {string}"
    weight = 5.0


@functional
class LeastTension(Extreme):
    """The least tension in a string that never goes slack."""

    name = "least tension"
    quantity = Tension
    sign = -1.0
    phrase = "the least tension in {string}"
