"""The first time that a body is back at its starting point."""

from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Acceleration, Displacement, Velocity
from sim2reason.quantities.subjects.bodies import Bodies
from sim2reason.quantities.subjects.paths import rides
from sim2reason.questions.crossing import crossings
from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.parts.passage import Passage
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

BACK = 1e-5  # of its greatest distance from there: what comes no nearer passes by
SLOW = 1e-3  # of its greatest speed: what is slower there turns back at that point


@MOMENTS.register("returned")
@dataclass(frozen=True, slots=True)
class Returned(Passage):
    """The first time that a body is back at its starting point."""

    label = "return"
    drawn_by_recipes = False
    of = Bodies()
    hangs_on = "displacement"
    verb = Verb("returns to its starting point", "return to its starting point")

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the phrases of the bodies that ride on no other body, so that the point is fixed in the room."""
        called = words.called(cls.of).items()
        return {
            name: cls.of.point(words.mechanism, name, said) for name, said in called if not rides(words.mechanism, name)
        }

    def excess(self, state: State) -> Array:
        """Return r·v, half the rate of the squared distance from the start, in m²/s, (n,)."""
        return np.einsum("ij,ij->i", Displacement.evaluate(state, self.name), Velocity.evaluate(state, self.name))

    def time(self, trace: Trace) -> float | None:
        """Return when the distance is first least and zero, s; None if the body does not come back."""
        farthest = float(np.linalg.norm(Displacement.evaluate(trace.scan, self.name), axis=1).max())
        fastest = float(np.linalg.norm(Velocity.evaluate(trace.scan, self.name), axis=1).max())
        for time in crossings(trace, self.excess):
            there = trace.at(time)
            if float(np.linalg.norm(Displacement.evaluate(there, self.name))) <= BACK * farthest:
                slow = float(np.linalg.norm(Velocity.evaluate(there, self.name))) <= SLOW * fastest
                return self._turn(trace, time) if slow else time
        return None

    def _turn(self, trace: Trace, near: float) -> float:
        """Return the time, s, near another one at which the speed is least: it tells more exactly when that is."""

        def gains(state: State) -> Array:
            return np.einsum("ij,ij->i", Velocity.evaluate(state, self.name), Acceleration.evaluate(state, self.name))

        return min(crossings(trace, gains), key=lambda time: abs(time - near), default=near)
