"""The kinetic energy that is lost in one collision."""

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects.pairs import Pairs
from sim2reason.questions.functionals import Functional, functional
from sim2reason.questions.functionals.parts.encounter import encounter
from sim2reason.questions.functionals.parts.jump import energies, energy_lost, hits
from sim2reason.questions.moments import Moment
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@functional
class CollisionLoss(Functional):
    """The kinetic energy that two bodies lose as they collide."""

    name, unit, kind, least = "energy lost in a collision", "J", "sum", 1e-3
    of, needs = Pairs(), ("mass",)
    phrase = "the kinetic energy that {pair} lose together"
    how = "how much kinetic energy do {pair} lose together {when}?"
    indirect = "how much kinetic energy {pair} lose together"
    weight = 5.0

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """As in: in their second collision."""
        return encounter(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """The loss of all bodies; None if something else collides at the same instant."""
        del name
        alone = hits(trace, end).count(end) == 1
        return energy_lost(trace, [end]) if alone else None

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """All kinetic energies."""
        del name
        return energies(mechanism)
