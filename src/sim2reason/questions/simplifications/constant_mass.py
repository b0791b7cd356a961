"""What burns fuel is taken to keep its mass."""

from sim2reason.dsl.mechanism import Burn, Mechanism
from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.burning import BurningSlip, without_loss


@simplification
class ConstantMass(BurningSlip):
    """What burns fuel is taken to keep its mass."""

    name = "constant mass"
    reason = "the mass of {subject} is taken as constant"

    def burnt(self, mechanism: Mechanism, burn: Burn) -> Burn:
        """Return the same thrust from next to no mass."""
        del mechanism
        return without_loss(burn)
