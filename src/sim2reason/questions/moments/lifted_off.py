"""The instant at which a rocket that was too heavy at first leaves the ground."""

from dataclasses import dataclass

from sim2reason.dsl.mechanism import Prop
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.occurrence import Occurrence
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Event, Trace


@MOMENTS.register("lifted_off")
@dataclass(frozen=True, slots=True)
class LiftedOff(Occurrence):
    """The instant at which what burns fuel leaves the ground, if its thrust is less than its weight at first."""

    label = "lift-off of a rocket"
    own = True
    drawn_by_recipes = False
    kinds = ("leave",)
    of = Bodies()
    most = 0
    verb = Verb("leaves the ground", "leave the ground")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """What burns fuel and stands on a prop."""
        mechanism = words.mechanism
        held = {
            mechanism.site[site].body for line in mechanism.lines if isinstance(line.law, Prop) for site in line.through
        }
        burns = {burn.body for burn in mechanism.burns}
        return {name: said for name, said in words.called(cls.of).items() if name in held & burns}

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Whether the prop of this body is pressed no more."""
        mechanism = trace.mechanism
        line = mechanism.line.get(event.subjects[0]) if event.kind in self.kinds and event.subjects else None
        return line is not None and self.name in {mechanism.site[site].body for site in line.through}
