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
    most = "greatest"
    verb = Verb("reach a maximum distance from each other", "reach a maximum distance from each other", "do")

    def extent(self, state: State) -> Array:
        """Their distance."""
        return DistanceBetween.evaluate(state, self.name)

    def excess(self, state: State) -> Array:
        """How fast they approach."""
        return -self.receding(state)
