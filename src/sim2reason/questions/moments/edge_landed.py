"""The landing of an edge of a body that tumbles over its edges, just before or just after it."""

from dataclasses import dataclass

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.occurrence import VelocityJump
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Event, Trace


@MOMENTS.register("edge_landed")
@dataclass(frozen=True, slots=True)
class EdgeLanded(VelocityJump):
    """The first landing of the next edge of a body that tumbles over its edges, or a later one, before or after it."""

    label = "landing of an edge"
    drawn_by_recipes = False
    kinds = ("land",)
    of = Bodies()
    most = 3
    verb = Verb("lands on its next edge", "land on its next edge")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the phrases of the bodies that stand on edges."""
        return {name: said for name, said in words.called(cls.of).items() if _edges(words.mechanism, name)}

    @classmethod
    def seen_as(cls, name: str, words: Words) -> set[str]:
        """Return the names of the edges of a body."""
        return _edges(words.mechanism, name)

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether an edge of the body lands."""
        return event.kind == "land" and event.subjects[0] in _edges(trace.mechanism, self.name)


def _edges(mechanism: Mechanism, name: str) -> set[str]:
    return {foot.name for foot in mechanism.feet if mechanism.site[foot.site].body == name}
