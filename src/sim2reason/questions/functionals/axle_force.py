"""The greatest force of a fixed axle."""

from sim2reason.quantities.axle_force import AxleForce
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestAxleForce(Extreme):
    """The greatest size of the force that a fixed axle exerts on the body that turns about it."""

    name = "greatest axle force"
    quantity = AxleForce
    impulsive = True
    phrase = "the greatest magnitude of the force that the axle exerts on {body}"
    weight = 3.0
