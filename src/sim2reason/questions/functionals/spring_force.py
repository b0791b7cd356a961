"""The greatest force of a spring."""

from sim2reason.quantities.springs import SpringForce
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestSpringForce(Extreme):
    """The greatest force of a spring, pull or push; asked for by people alone."""

    name = "greatest spring force"
    quantity = SpringForce
    phrase = "the greatest force exerted by {spring}"
    weight = 0.0
