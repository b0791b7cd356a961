"""The greatest force of a spring."""

from sim2reason.quantities.springs import SpringForce
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestSpringForce(Extreme):
    """The greatest magnitude of the force of a spring, N, whether it pulls or pushes; never drawn by recipes."""

    name = "greatest spring force"
    quantity = SpringForce
    phrase = "the greatest force exerted by {spring}"
    drawn_by_recipes = False
