"""The first time that two bodies are closest to each other."""

from dataclasses import dataclass

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.pairs import DistanceBetween
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.apsis import Apsis
from sim2reason.questions.moments.parts.verbs import Verb


@MOMENTS.register("closest")
@dataclass(frozen=True, slots=True)
class Closest(Apsis):
    """The first time that two bodies are closest to each other."""

    label = "closest approach"
    most = "least"
    verb = Verb("reach a minimum distance from each other", "reach a minimum distance from each other", "do")

    def extent(self, state: State) -> Array:
        """Their distance, with a minus sign."""
        return -DistanceBetween.evaluate(state, self.name)

    def excess(self, state: State) -> Array:
        """How fast they part."""
        return self.receding(state)
