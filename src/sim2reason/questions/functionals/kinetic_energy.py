"""The greatest kinetic energy of a body."""

from sim2reason.quantities.energy import KineticEnergy
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestKineticEnergy(Extreme):
    """The greatest kinetic energy of a body, that of its turning included."""

    name = "greatest kinetic energy"
    quantity = KineticEnergy
    phrase = "the greatest kinetic energy of {body}{ground}"
    weight = 0.2  # rather its greatest speed
