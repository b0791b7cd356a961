"""How near two bodies come to each other, and how far they get from each other."""

from sim2reason.quantities.pairs import DistanceBetween
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestDistance(Extreme):
    """The greatest distance between two bodies."""

    name = "greatest distance"
    quantity = DistanceBetween
    phrase = "the greatest distance between {pair}"
    weight = 2.0


@functional
class LeastDistance(Extreme):
    """The least distance between two bodies that do not touch."""

    name = "least distance"
    quantity = DistanceBetween
    sign = -1.0
    phrase = "the least distance between {pair}"
    how = "how near to each other do {pair} come {when}?"
    weight = 2.0
