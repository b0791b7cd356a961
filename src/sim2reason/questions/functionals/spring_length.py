"""How long, and how short, a spring becomes."""

from sim2reason.quantities.springs import SpringLength
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestSpringLength(Extreme):
    """The greatest length of a spring; asked for by people alone."""

    name = "greatest spring length"
    quantity = SpringLength
    phrase = "the greatest length of {spring}"
    weight = 0.0


@functional
class LeastSpringLength(Extreme):
    """The least length of a spring; asked for by people alone."""

    name = "least spring length"
    quantity = SpringLength
    sign = -1.0
    phrase = "the least length of {spring}"
    weight = 0.0
