"""The greatest force in a light rod."""

from sim2reason.quantities.rods import RodForce, RodPull
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestRodForce(Extreme):
    """The greatest size of the force in a light rod, be it a pull or a push."""

    name = "greatest rod force"
    quantity = RodForce
    impulsive = True
    phrase = "the greatest magnitude of the force in {rod}"
    weight = 5.0


@functional
class GreatestRodPull(Extreme):
    """The greatest size of the force in a light rod on a moving axle; never drawn by recipes."""

    name = "greatest rod pull"
    quantity = RodPull
    impulsive = True
    drawn_by_recipes = False
    phrase = "the greatest magnitude of the force in {rod}"
