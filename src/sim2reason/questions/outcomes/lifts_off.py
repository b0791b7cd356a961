"""Whether a rocket that stands on the ground rises as soon as its engine starts."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Self

from sim2reason.dsl.scene import Scene
from sim2reason.quantities.kinematics import Acceleration
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.outcomes import NOTHING, ONSET, OUTCOMES, PossibleOutcome
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace


@OUTCOMES.register("lifts_off")
@dataclass(frozen=True, slots=True)
class LiftsOff(PossibleOutcome):
    """A body with an engine that stands on the ground rises at once; only people ask about it."""

    of = Bodies()

    @classmethod
    def found(cls, words: Words) -> Sequence[Self]:
        """None: recipes do not ask about it."""
        del words
        return ()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """What burns fuel where gravity is uniform."""
        mechanism = words.mechanism
        burning = {burn.body for burn in mechanism.burns} if any(mechanism.gravity) else set[str]()
        return {name: said for name, said in words.called(cls.of).items() if name in burning}

    def duration(self, scene: Scene) -> float:
        """A moment."""
        return ONSET * scene.horizon

    def happens(self, trace: Trace) -> bool:
        """Whether it is accelerated upwards at once."""
        return self.excess(trace) > NOTHING

    def excess(self, trace: Trace) -> float:
        """The upward acceleration at the start."""
        return float(Acceleration.evaluate(trace.at(0.0), self.name)[0, 2])

    def does(self, words: Words) -> tuple[str, ...]:
        """As in: the probe rises at once."""
        return (f"{self.subject(words)} rises at once",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """As in: the probe does not rise at once."""
        return (f"{self.subject(words)} does not rise at once",)
