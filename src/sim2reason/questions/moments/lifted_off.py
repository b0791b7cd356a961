"""The instant at which a rocket that was too heavy at first leaves the ground."""

from dataclasses import dataclass

from sim2reason.dsl.mechanism import Mechanism, Prop
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
        """Return the phrases of the bodies that burn fuel and stand on props."""
        burns = {burn.body for burn in words.mechanism.burns}
        called = words.called(cls.of).items()
        return {name: said for name, said in called if name in burns and cls.seen_as(name, words)}

    @classmethod
    def seen_as(cls, name: str, words: Words) -> set[str]:
        """Return the names of the props on which a body stands: its lift-off is recorded as an event of these."""
        return _props(words.mechanism, name)

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether at this event a prop of the body stops carrying load."""
        return event.kind in self.kinds and not _props(trace.mechanism, self.name).isdisjoint(event.subjects)


def _props(mechanism: Mechanism, name: str) -> set[str]:
    """Return the names of the props on which a body stands."""
    props = (line for line in mechanism.lines if isinstance(line.law, Prop))
    return {line.name for line in props if name in {mechanism.site[site].body for site in line.through}}
