"""The first time that a body that moves in a plane is a stated distance from its starting point."""

from dataclasses import dataclass

import numpy as np

from sim2reason.dsl.state import Array, State
from sim2reason.quantities.kinematics import Displacement
from sim2reason.quantities.subjects.bodies import AXES, Bodies
from sim2reason.quantities.subjects.paths import center_path
from sim2reason.questions.moments import MOMENTS, Clause
from sim2reason.questions.moments.moved import drawn_distance
from sim2reason.questions.moments.parts.passage import Threshold
from sim2reason.questions.moments.parts.verbs import Verb
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace


@MOMENTS.register("away")
@dataclass(frozen=True, slots=True)
class Away(Threshold):
    """The first time that a body that moves freely in a plane is a stated distance from its starting point."""

    label = "away"
    of = Bodies()
    verb = Verb("is", "", "is")
    hangs_on = "displacement"
    unit = "m"

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Bodies whose text gives their plane axes."""
        mechanism = words.mechanism
        called = words.called(cls.of).items()
        return {n: s for n, s in called if _has_axes(words, n) and not center_path(mechanism, n).straight}

    @classmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """A part of how far it gets."""
        return drawn_distance(name, trace, rng)

    def excess(self, state: State) -> Array:
        """How much farther it is than the distance."""
        return np.linalg.norm(Displacement.evaluate(state, self.name), axis=1) - self.value

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: when the puck is first 0.50 m from its starting point."""
        first = f"{self.subject(words)} is first {self.said(words)} from its starting point"
        return (f"when {first}", f"at the moment when {first}", f"at the instant at which {first}")

    def clause(self, words: Words) -> Clause | None:
        """As in: the puck is first 0.50 m from its starting point."""
        there = f"first {self.said(words)} from its starting point"
        return Clause(self.subject(words), "is", there, f"is {there}")


def _has_axes(words: Words, name: str) -> bool:
    own = words.mechanism.body[name].coordinates
    return len(own) > 1 and all(c.label in AXES for c in own)
