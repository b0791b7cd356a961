"""The mass of the fuel is left out."""

from dataclasses import replace

from sim2reason.dsl.ablation import with_bodies
from sim2reason.dsl.mechanism import Burn, Mechanism
from sim2reason.questions.simplifications import simplification
from sim2reason.questions.simplifications.parts.burning import BurningSlip, without_loss


@simplification
class FuelLeftOut(BurningSlip):
    """A rocket is taken to have its empty mass from the start."""

    name = "fuel left out"
    reason = "the mass of the fuel of {subject} is left out"

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism in which one rocket has the same thrust but carries no fuel."""
        spent = {burn.body: burn.rate * burn.until for burn in mechanism.burns}
        lighter = with_bodies(mechanism, [subject], lambda body: replace(body, mass=body.mass - spent[subject]))
        return super().changed(lighter, subject)

    def burnt(self, mechanism: Mechanism, burn: Burn) -> Burn:
        """Return a burn of the same thrust that ejects almost no mass."""
        del mechanism
        return without_loss(burn)
