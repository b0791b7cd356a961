"""The greatest and the least normal force on a body."""

from sim2reason.quantities.contact import NormalForce
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestNormalForce(Extreme):
    """The greatest normal force that a face exerts on a body."""

    name = "greatest normal force"
    quantity = NormalForce
    impulsive = True
    phrase = "the greatest normal force exerted on {body} by {surface}"
    weight = 2.0


@functional
class LeastNormalForce(Extreme):
    """The least normal force that a face exerts on a body."""

    name = "least normal force"
    quantity = NormalForce
    sign = -1.0
    phrase = "the least normal force exerted on {body} by {surface}"
