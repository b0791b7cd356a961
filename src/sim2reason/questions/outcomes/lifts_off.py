"""The outcome that a rocket rises from the ground as soon as its engine starts."""

from dataclasses import dataclass

from sim2reason.quantities.kinematics import Acceleration
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.questions.outcomes import NOTHING, OUTCOMES, Onset
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace


@OUTCOMES.register("lifts_off")
@dataclass(frozen=True, slots=True)
class LiftsOff(Onset):
    """The outcome that a body with an engine rises from the ground at once; only people ask about it."""

    of = Bodies()
    drawn_by_recipes = False

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the bodies that burn fuel, if gravity is uniform; else none."""
        mechanism = words.mechanism
        burning = {burn.body for burn in mechanism.burns} if any(mechanism.gravity) else set[str]()
        return {name: said for name, said in words.called(cls.of).items() if name in burning}

    def happens(self, trace: Trace) -> bool:
        """Return whether the body is accelerated upwards at the start."""
        return self.excess(trace) > NOTHING

    def excess(self, trace: Trace) -> float:
        """Return the upward acceleration at the start, m/s²."""
        return float(Acceleration.evaluate(trace.at(0.0), self.name)[0, 2])

    def does(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the probe rises at once*."""
        return (f"{self.subject(words)} rises at once",)

    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return the clause *the probe does not rise at once*."""
        return (f"{self.subject(words)} does not rise at once",)
