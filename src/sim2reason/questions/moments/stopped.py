"""The first time that a body that was moving comes to rest."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.quantities import QUANTITIES
from sim2reason.questions.choices import free_bodies, named
from sim2reason.questions.moments import MOMENTS, Clause, Happening
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Event, Trace

STILL = 1e-9  # m/s


@MOMENTS.register("stopped")
@dataclass(frozen=True, slots=True)
class Stopped(Happening):
    """The first time that a body that was moving comes to rest, be it for an instant."""

    label = "rest"
    event = True

    body: str

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Every free body that does."""
        del rng
        found = [cls(name) for name in free_bodies(study.mechanism, words)]
        return [moment for moment in found if study.time(moment) is not None]

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Every body that is named."""
        return (cls(name) for name in named(text, trace.mechanism, words))

    @property
    def subjects(self) -> tuple[str, ...]:
        """The body."""
        return (self.body,)

    def time(self, trace: Trace) -> float | None:
        """The first event that ends the motion of one of its coordinates."""
        ended = next((e for e in trace.events if e.time > 0.0 and self._ends(e, trace)), None)
        return ended.time if ended is not None and self._rests(trace, ended.time) else None

    def _ends(self, event: Event, trace: Trace) -> bool:
        if event.kind == "turn":
            return any(c.name in event.subjects for c in trace.mechanism.body[self.body].coordinates)
        return event.kind in ("stick", "slip") and self.body in event.subjects

    def _rests(self, trace: Trace, time: float) -> bool:
        velocity = QUANTITIES["velocity"].evaluate(trace.sample(np.array([time])), self.body)
        return float(np.linalg.norm(velocity[0])) < STILL

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: when the block first comes to rest."""
        body = words.mentions[self.body]
        return (
            f"when {body} first comes to rest",
            f"at the moment when {body} first comes to rest",
            f"when {body} comes to rest for the first time",
        )

    def clause(self, words: Words) -> Clause | None:
        """As in: the block first comes to rest."""
        return Clause(words.mentions[self.body], "does", "first come to rest", "first comes to rest")
