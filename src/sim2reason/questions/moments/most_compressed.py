"""The first time that a spring is compressed the most."""

from dataclasses import dataclass

from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.spring_turn import SpringTurn
from sim2reason.questions.moments.parts.verbs import Verb


@MOMENTS.register("most_compressed")
@dataclass(frozen=True, slots=True)
class MostCompressed(SpringTurn):
    """The first time that a spring is compressed the most."""

    label = "greatest compression"
    verb = Verb("reaches its maximum compression", "reach its maximum compression")
    local_verb = Verb("reaches a maximum of its compression", "reach a maximum of its compression")

    def sign(self) -> float:
        """Its length is then the shortest."""
        return -1.0
