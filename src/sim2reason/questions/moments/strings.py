"""Moments of strings and springs."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Self

import numpy as np

from sim2reason.questions.moments import MOMENTS
from sim2reason.questions.moments.crossings import Passage, first_crossing
from sim2reason.questions.moments.extrema import SpringTurn
from sim2reason.questions.moments.occurrence import Occurrence, VelocityJump, Verb
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import Elastic, Inextensible, Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities.force_laws import Extension
from sim2reason.simulation.quantities.subjects.interactions import Springs, Strings
from sim2reason.simulation.trace import Channel, Trace


@MOMENTS.register("went_slack")
@dataclass(frozen=True, slots=True)
class WentSlack(Occurrence):
    """The first time that a string goes slack."""

    label = "slack"
    kinds = ("slack",)
    of = Strings()
    verb = Verb("goes slack", "go slack")


@MOMENTS.register("went_taut")
@dataclass(frozen=True, slots=True)
class WentTaut(VelocityJump):
    """The first time that a slack string becomes taut with a jerk; *again* if it was taut at the start."""

    label = "taut"
    own = False
    kinds = ("taut",)
    of = Strings()
    verb = Verb("becomes taut", "become taut")

    def does(self, words: Words) -> Verb:
        """Return the verb for a string that the text calls taut or slack at the start."""
        law = words.mechanism.line[self.name].law
        spare = isinstance(law, Inextensible) and law.slack > 0.0
        return self.verb if spare else Verb("becomes taut again", "become taut again")


@MOMENTS.register("most_compressed")
@dataclass(frozen=True, slots=True)
class MostCompressed(SpringTurn):
    """The first time that a spring is compressed the most."""

    label = "greatest compression"
    verb = Verb("reaches its maximum compression", "reach its maximum compression")
    local_verb = Verb("reaches a maximum of its compression", "reach a maximum of its compression")

    def sign(self) -> float:
        """Return −1, as the moment is one of greatest compression."""
        return -1.0


@MOMENTS.register("most_stretched")
@dataclass(frozen=True, slots=True)
class MostStretched(SpringTurn):
    """The first time that a spring is stretched the most."""

    label = "greatest extension"
    verb = Verb("reaches its maximum extension", "reach its maximum extension")
    local_verb = Verb("reaches a maximum of its extension", "reach a maximum of its extension")

    def sign(self) -> float:
        """Return 1, as the moment is one of greatest extension."""
        return 1.0


RELAXED_RTOL = 1e-9  # of the natural length: smaller extensions are zero


@MOMENTS.register("natural_length")
@dataclass(frozen=True, slots=True)
class NaturalLength(Passage):
    """The first time after the start that a spring has its natural length."""

    label = "natural length"
    of = Springs()
    hangs_on = "extension"
    verb = Verb("has its natural length", "have its natural length")
    again: ClassVar[Verb] = Verb("has its natural length again", "have its natural length again")

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return the moments of springs that are strained at the start."""
        del rng
        strained = (cls(name) for name in cls.candidates(words) if not _is_relaxed_at_start(words.mechanism, name))
        return [moment for moment in strained if moment.comes(study)]

    def does(self, words: Words) -> Verb:
        """Return the verb *has its natural length*, with *again* if that holds at the start."""
        return self.again if _is_relaxed_at_start(words.mechanism, self.name) else self.verb

    def excess(self, state: State) -> Array:
        """Return the extension, m, (n,)."""
        return Extension.evaluate(state, self.name)

    def time(self, trace: Trace) -> float | None:
        """Return the first time after the start, s, at which the spring passes its natural length; None if never."""
        times = [first_crossing(trace, self.excess), first_crossing(trace, lambda state: -self.excess(state))]
        return min((time for time in times if time is not None), default=None)

    @property
    def revealed_channels(self) -> tuple[Channel, ...]:
        """Return the channels of the extension, length and force, whose values follow from the natural length."""
        return self.channels


def _is_relaxed_at_start(mechanism: Mechanism, name: str) -> bool:
    """Return whether a spring has its natural length at the start."""
    line = mechanism.line[name]
    assert isinstance(line.law, Elastic)
    return abs(initial_frames(mechanism).length(line) - line.law.length) <= RELAXED_RTOL * line.law.length
