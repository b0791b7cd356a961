"""The greatest angular speed, and the greatest angular acceleration, of a body."""

from sim2reason.quantities.rotation import AngularAcceleration, AngularVelocity
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestAngularSpeed(Extreme):
    """The greatest angular speed of a body."""

    name = "greatest angular speed"
    quantity = AngularVelocity
    phrase = "the greatest angular speed of {body}"
    weight = 2.0


@functional
class GreatestAngularAcceleration(Extreme):
    """The greatest angular acceleration of a body; never drawn by recipes."""

    name = "greatest angular acceleration"
    quantity = AngularAcceleration
    impulsive = True
    drawn_by_recipes = False
    phrase = "the greatest angular acceleration of {body}"
