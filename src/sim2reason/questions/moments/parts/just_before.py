"""The instant just before what happens, at which a force or an acceleration may jump."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.questions.moments import Clause, Happening, Moment
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


@dataclass(frozen=True, slots=True)
class JustBefore(Happening):
    """Just before another moment, the words of which say no side; people ask for it, and nothing draws it."""

    label = "before"

    inner: Moment

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """None."""
        del study, words, rng
        return ()

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """None: the words of ordinary English for it are read as a question in parts."""
        del text, trace, words
        return iter(())

    @property
    def subjects(self) -> tuple[str, ...]:
        """Those of the moment."""
        return self.inner.subjects

    @property
    def channels(self) -> tuple[Channel, ...]:
        """Those of the moment."""
        return self.inner.channels

    @property
    def sided(self) -> bool | None:
        """Just before it."""
        return False

    def time(self, trace: Trace) -> float | None:
        """That of the moment."""
        return self.inner.time(trace)

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: just before the block comes to rest."""
        told = (phrase for phrase in self.inner.phrases(words) if phrase.startswith("when "))
        return tuple(f"just before {phrase.removeprefix('when ')}" for phrase in told)

    def clause(self, words: Words) -> Clause | None:
        """None: when it comes is asked of the moment itself."""
        del words
        return None

    def subject(self, words: Words) -> str:
        """That of the moment."""
        return self.inner.subject(words)
