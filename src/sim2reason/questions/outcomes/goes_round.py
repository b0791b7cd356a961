"""Whether what swings makes a full turn."""

from dataclasses import dataclass

import numpy as np

from sim2reason.quantities.rotation import AngleTurned
from sim2reason.quantities.subjects.paths import turning_axes
from sim2reason.quantities.subjects.turners import TurningBodies
from sim2reason.questions.outcomes import OUTCOMES, Swinging
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

FULL = 360.0  # degrees


@OUTCOMES.register("goes_round")
@dataclass(frozen=True, slots=True)
class GoesRound(Swinging):
    """A rod or another body on an axle goes right round."""

    of = TurningBodies()

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """What swings under gravity on one axle, and is set moving; by falling alone nothing gets over the top."""
        if not any(words.mechanism.gravity) or words.mechanism.feet or words.released:
            return {}
        turning = AngleTurned().subjects(words.mechanism)
        return {name: said for name, said in words.called(cls.of).items() if name in turning}

    def happens(self, trace: Trace) -> bool | None:
        """Whether it has gone round before it turns back first, which takes long where it hardly gets over the top."""
        hinges = {name for name, _ in turning_axes(trace.mechanism, self.name)}
        back = next(
            (event.time for event in trace.events if event.kind == "turn" and event.subjects[0] in hinges), None
        )
        state = trace.state if back is None else trace.at(back)
        round_once = bool(np.abs(AngleTurned.evaluate(state, self.name)).max() >= FULL)
        return round_once or (None if back is None else False)

    def excess(self, trace: Trace) -> float:
        """The square of the least rate at which it turns: it grows as the energy that is left at the top does."""
        number = trace.mechanism.number
        hinges = [number[name] for name, _ in turning_axes(trace.mechanism, self.name)]
        return float(np.square(trace.scan.v[:, hinges].sum(axis=1)).min())

    def does(self, words: Words) -> tuple[str, ...]:
        """As in: the rod makes a full turn."""
        subject = self.subject(words)
        return (f"{subject} makes a full turn", f"{subject} goes right round")

    def does_not(self, words: Words) -> tuple[str, ...]:
        """As in: the rod does not make a full turn."""
        subject = self.subject(words)
        return (f"{subject} does not make a full turn", f"{subject} does not go right round")
