"""The first time that a spring is stretched the most."""

from dataclasses import dataclass

from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.spring_turn import SpringTurn
from sim2reason.questions.moments.parts.verbs import Verb


@MOMENTS.register("most_stretched")
@dataclass(frozen=True, slots=True)
class MostStretched(SpringTurn):
    """The first time that a spring is stretched the most."""

    label = "greatest extension"
    verb = Verb("reaches its maximum extension", "reach its maximum extension")
    local_verb = Verb("reaches a maximum of its extension", "reach a maximum of its extension")

    def sign(self) -> float:
        """Its length is then the longest."""
        return 1.0
