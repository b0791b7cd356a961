"""Whether a body that is let go moves up."""

from dataclasses import dataclass

from sim2reason.quantities.kinematics import Velocity
from sim2reason.quantities.subjects.bodies import UP, Bodies
from sim2reason.quantities.subjects.paths import center_path, rides
from sim2reason.questions.outcomes import OUTCOMES, Onset, is_steady_release, rest_speed_noise
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace


@OUTCOMES.register("rises")
@dataclass(frozen=True, slots=True)
class Rises(Onset):
    """A body that can move up and down along a line starts upwards."""

    of = Bodies()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """What has one line to move along that is not level, and rides on nothing, where something could lift it."""
        mechanism = words.mechanism
        if not is_steady_release(words) or not (mechanism.lines or mechanism.forces):
            return {}
        called = words.called(cls.of).items()
        paths = {name: center_path(mechanism, name) for name, _ in called}
        return {n: said for n, said in called if paths[n].straight and paths[n].rises and not rides(mechanism, n)}

    def happens(self, trace: Trace) -> bool:
        """Whether it has an upward velocity."""
        return self.excess(trace) > 0.0

    def excess(self, trace: Trace) -> float:
        """That velocity, but for what is none."""
        return float(Velocity.evaluate(trace.state, self.name)[-1, 2]) - rest_speed_noise(trace)

    def does(self, words: Words) -> tuple[str, ...]:
        """As in: block A starts to move up the slope."""
        return (f"{self.subject(words)} starts to move {self._way(words)}",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """As in: block A does not start to move up the slope."""
        return (f"{self.subject(words)} does not start to move {self._way(words)}",)

    def _way(self, words: Words) -> str:
        senses = self.of.senses(words.mechanism, self.name)
        return senses[0].positive if senses else UP
