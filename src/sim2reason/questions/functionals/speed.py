"""The greatest and the least speed of a body."""

from sim2reason.quantities.kinematics import Velocity
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestSpeed(Extreme):
    """The greatest speed of a body."""

    name = "greatest speed"
    quantity = Velocity
    phrase = "the greatest speed of {body}{ground}"
    weight = 2.0


@functional
class LeastSpeed(Extreme):
    """The least speed of a body that never stops."""

    name = "least speed"
    quantity = Velocity
    sign = -1.0
    phrase = "the least speed of {body}{ground}"
