"""The greatest angular speed of a body."""

from sim2reason.quantities.rotation import AngularVelocity
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestAngularSpeed(Extreme):
    """The greatest angular speed of a body."""

    name = "greatest angular speed"
    quantity = AngularVelocity
    phrase = "the greatest angular speed of {body}"
    weight = 2.0
