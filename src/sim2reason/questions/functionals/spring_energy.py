"""The greatest energy stored in a spring."""

from sim2reason.quantities.springs import SpringEnergy
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestSpringEnergy(Extreme):
    """The greatest energy stored in a spring."""

    name = "greatest spring energy"
    quantity = SpringEnergy
    phrase = "the greatest energy stored in {spring}"
