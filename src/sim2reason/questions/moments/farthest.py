"""The first time that two bodies are farthest from each other."""

from dataclasses import dataclass

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.pairs import DistanceBetween
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.apsis import Apsis
from sim2reason.questions.moments.parts.verbs import Verb


@MOMENTS.register("farthest")
@dataclass(frozen=True, slots=True)
class Farthest(Apsis):
    """The first time that two bodies are farthest from each other."""

    label = "farthest apart"
    verb = Verb("are farthest from each other", "farthest from each other", "are")

    def extent(self, state: State) -> Array:
        """Their distance."""
        return DistanceBetween.evaluate(state, self.name)

    def excess(self, state: State) -> Array:
        """How fast they approach."""
        return -self.receding(state)
