"""How far a string or a rod swings out, or how close to the vertical it comes without passing it."""

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


@functional
class LeastDeflection(Extreme):
    """The least angle that a line makes with the downward vertical, of a line that does not pass the vertical."""

    name = "least deflection"
    quantity = Deflection
    sign = -1.0
    drawn_by_recipes = False
    phrase = "the least angle that {line} makes with the downward vertical"
