"""The moment at which an engine burns out."""

from dataclasses import dataclass

from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.occurrence import Occurrence, Verb
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.quantities.subjects.bodies import Bodies


@MOMENTS.register("burned_out")
@dataclass(frozen=True, slots=True)
class BurnedOut(Occurrence):
    """Burn-out: the instant at which all fuel is used up."""

    label = "burn-out"
    own = True
    kinds = ("burn-out",)
    of = Bodies()
    most = 0
    verb = Verb("runs out of fuel", "run out of fuel")

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *when the rocket runs out of fuel*."""
        rocket = self.subject(words)
        return (
            f"when {rocket} has burnt all its fuel",
            f"when {rocket} runs out of fuel",
            f"at the moment when {rocket} has used up its fuel",
        )

    @property
    def revealed_channels(self) -> tuple[Channel, ...]:
        """Return the channel of the body's mass, which the text gives."""
        return (Channel(self.name, "mass"),)

    def is_plain(self, study: SimulatedScene) -> bool:
        """Return True: the fuel mass divided by the burn rate is the time, which needs no physics."""
        del study
        return True
