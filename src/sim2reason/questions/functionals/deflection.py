"""How far a string or a rod swings out, or how close to the vertical it comes without passing it."""

from sim2reason.quantities.inclination import Deflection
from sim2reason.questions.functionals import functional
from sim2reason.questions.functionals.parts.extreme import Extreme
from sim2reason.simulation.trace import Trace

UPRIGHT = 1e-3  # degrees: a line that comes closer to the vertical passes it


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

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the least angle, in degrees; None if the line passes the vertical."""
        found = Extreme.value(self, trace, name, end)
        return found if found is not None and found > UPRIGHT else None
