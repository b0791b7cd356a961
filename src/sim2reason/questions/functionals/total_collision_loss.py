"""The kinetic energy that is lost in several collisions."""

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects.whole import Whole
from sim2reason.questions.functionals import Functional, functional
from sim2reason.questions.functionals.parts.jump import energies, energy_lost, hits
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.last_collision import LastCollision
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace

FEWEST = 2  # collisions


@functional
class TotalCollisionLoss(Functional):
    """The kinetic energy that is lost in all collisions up to a moment."""

    name, unit, kind, least = "energy lost in collisions", "J", "sum", 1e-3
    of, needs = Whole(), ("mass",)
    phrase = "the total kinetic energy lost in collisions"
    how = "how much kinetic energy is lost in collisions altogether {when}?"
    weight = 4.0

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Also of all that ever happen."""
        if isinstance(moment, LastCollision):
            return (f"from {words.since} on", "in the motion that follows", "in the whole motion")
        return super().when(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """The sum over all collisions."""
        del name
        return energy_lost(trace, hits(trace, end))

    def worth(self, study: Study, name: str, end: float) -> bool:
        """Whether there are several."""
        del name
        return len(hits(study.trace, end)) >= FEWEST

    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """All kinetic energies."""
        del name
        return energies(mechanism)
