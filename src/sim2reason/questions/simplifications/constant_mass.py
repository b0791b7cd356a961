"""A rocket is taken to keep its mass as it burns fuel."""

from sim2reason.dsl.mechanism import Burn, Mechanism
from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.burning import BurningSlip, without_loss


@simplification
class ConstantMass(BurningSlip):
    """A rocket is taken to keep its mass as it burns fuel."""

    name = "constant mass"
    reason = "the mass of {subject} is taken as constant"

    def burnt(self, mechanism: Mechanism, burn: Burn) -> Burn:
        """Return a burn of the same thrust that ejects almost no mass."""
        del mechanism
        return without_loss(burn)
