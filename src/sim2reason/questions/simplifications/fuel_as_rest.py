"""The empty mass of a rocket is mistaken for the mass of its fuel."""

from dataclasses import replace

from sim2reason.dsl.mechanism import Burn, Mechanism
from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.burning import BurningSlip


@simplification
class FuelAsRest(BurningSlip):
    """The empty mass of a rocket is mistaken for the mass of its fuel."""

    name = "fuel mass for empty mass"
    reason = "the mass of {subject} without fuel is taken for the mass of its fuel"

    def burnt(self, mechanism: Mechanism, burn: Burn) -> Burn:
        """Return a burn that ejects the empty mass instead of the fuel."""
        left = mechanism.body[burn.body].mass - burn.rate * burn.until
        return replace(burn, until=left / burn.rate)
