"""The outcome that a body that is let go moves down."""

from dataclasses import dataclass

from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.outcomes import OUTCOMES, Onset, rest_speed_noise
from sim2reason.questions.outcomes.rises import Rises
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace


@OUTCOMES.register("sinks")
@dataclass(frozen=True, slots=True)
class Sinks(Onset):
    """A body that can move up and down along a line starts downwards; only people ask about it."""

    of = Bodies()
    drawn_by_recipes = False

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that may also rise, by name."""
        return Rises.candidates(words)

    def happens(self, trace: Trace) -> bool:
        """Return whether the body has a downward velocity."""
        return self.excess(trace) > 0.0

    def excess(self, trace: Trace) -> float:
        """Return the downward velocity, m/s, less what is none."""
        return -float(Velocity.evaluate(trace.state, self.name)[-1, 2]) - rest_speed_noise(trace)

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the clause *block A starts to move down*."""
        return (f"{self.subject(words)} starts to move down",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the clause *block A does not start to move down*."""
        return (f"{self.subject(words)} does not start to move down",)
