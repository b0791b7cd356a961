"""The greatest acceleration of a body."""

from sim2reason.quantities.kinematics import Acceleration
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestAcceleration(Extreme):
    """The greatest size of the acceleration of a body."""

    name = "greatest acceleration"
    quantity = Acceleration
    impulsive = True
    phrase = "the greatest magnitude of the acceleration of {body}{ground}"
    weight = 0.4
