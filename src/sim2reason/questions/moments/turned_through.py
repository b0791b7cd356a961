"""The first time that a body has turned through a stated angle from its starting position."""

from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.rotation import AngleTurned
from sim2reason.quantities.subjects.turners import TurningBodies
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.parts.passage import Threshold
from sim2reason.questions.moments.parts.verbs import Verb, when_phrases
from sim2reason.questions.spoken import spoken
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace

MOST = 330.0  # degrees


@MOMENTS.register("turned_through")
@dataclass(frozen=True, slots=True)
class TurnedThrough(Threshold):
    """The first time that a body on an axle is a stated angle from its starting position."""

    label = "turned"
    of = TurningBodies()
    verb = Verb("has turned", "turned", "has")
    hangs_on = "angle turned"
    unit = "deg"

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Bodies on one axle that do not roll."""
        turning = AngleTurned().subjects(words.mechanism)
        return {name: said for name, said in words.called(cls.of).items() if name in turning}

    @classmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """A part of how far it turns, in fives of degrees, or in tens if it has three digits."""
        reached = float(np.abs(AngleTurned.evaluate(trace.scan, name)).max())
        angle = spoken(5.0 * max(1, round(rng.uniform(0.2, 0.9) * min(reached, MOST) / 5.0)))
        return angle if angle < reached else None

    @property
    def tells(self) -> tuple[Channel, ...]:
        """The angle, and so that with the vertical."""
        return (*self.channels, Channel(self.name, "deflection"))

    def excess(self, state: State) -> Array:
        """How much farther it is turned than the angle, either way."""
        return np.abs(AngleTurned.evaluate(state, self.name)) - self.value

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: when the rod has turned through 30° from its starting position."""
        turned = f"{self.subject(words)} has first turned through {self.said(words)} from its starting position"
        return when_phrases(turned)

    def clause(self, words: Words) -> Clause | None:
        """As in: the rod has first turned through 30° from its starting position."""
        turned = f"first turned through {self.said(words)} from its starting position"
        takes = f"to turn through {self.said(words)} from its starting position for the first time"
        return Clause(self.subject(words), "has", turned, f"has {turned}", takes)
