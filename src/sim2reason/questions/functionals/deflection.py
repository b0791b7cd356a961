"""How far a string or a rod swings out."""

from sim2reason.quantities.inclination import Deflection
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme


@functional
class GreatestDeflection(Extreme):
    """The greatest angle that a line makes with the downward vertical."""

    name = "greatest deflection"
    quantity = Deflection
    phrase = "the greatest angle that {line} makes with the downward vertical"
    weight = 2.0
