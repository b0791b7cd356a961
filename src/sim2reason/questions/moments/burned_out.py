"""The instant at which an engine burns out."""

from dataclasses import dataclass

from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.parts.occurrence import Occurrence
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel


@MOMENTS.register("burned_out")
@dataclass(frozen=True, slots=True)
class BurnedOut(Occurrence):
    """Burn-out: the instant at which all fuel is used up."""

    label = "burn-out"
    own = True
    kinds = ("burn-out",)
    of = Bodies()
    most = 0
    pronoun = ""
    verb = Verb("burns out", "burn out")

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: when the engine of the rocket burns out."""
        rocket = self.subject(words)
        return (
            f"when {rocket} has burnt all its fuel",
            f"when the engine of {rocket} burns out",
            f"at the moment when the fuel of {rocket} is used up",
        )

    @property
    def tells(self) -> tuple[Channel, ...]:
        """The mass that is left, which the text gives."""
        return (Channel(self.name, "mass"),)

    def is_plain(self, study: Study) -> bool:
        """Fuel and rate give the time."""
        del study
        return True

    def clause(self, words: Words) -> Clause | None:
        """As in: the engine of the rocket burns out."""
        return self.verb.clause(f"the engine of {self.subject(words)}", None)
