"""The instant just before an event, at which a force or an acceleration may jump."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.questions.moments import Clause, Happening, Moment
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@dataclass(frozen=True, slots=True)
class JustBefore(Happening):
    """The instant just before another moment whose words name no side; only for structured questions, never drawn."""

    label = "before"

    inner: Moment

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return no moments, since none are ever drawn."""
        del study, words, rng
        return ()

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Return no moments: a sentence about such an instant is read as a structured question."""
        del text, trace, words
        return iter(())

    @property
    def subjects(self) -> tuple[str, ...]:
        """Return the subjects of the inner moment."""
        return self.inner.subjects

    @property
    def channels(self) -> tuple[Channel, ...]:
        """Return the channels of the inner moment."""
        return self.inner.channels

    @property
    def sided(self) -> bool | None:
        """Return False, for just before the event."""
        return False

    def time(self, trace: Trace) -> float | None:
        """Return the time of the inner moment, s; None if the moment does not occur."""
        return self.inner.time(trace)

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return phrases such as *just before the block comes to rest*."""
        told = (phrase for phrase in self.inner.phrases(words) if phrase.startswith("when "))
        return tuple(f"just before {phrase.removeprefix('when ')}" for phrase in told)

    def clause(self, words: Words) -> Clause | None:
        """Return None: a question about the time asks about the inner moment instead."""
        del words
        return None

    def subject(self, words: Words) -> str:
        """Return the phrase for the inner moment's subject."""
        return self.inner.subject(words)
