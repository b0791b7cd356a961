"""The first collision of two bodies, just before or just after it."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.questions.moments import MOMENTS, Clause, Happening
from sim2reason.questions.spoken import pair
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace


@MOMENTS.register("collided")
@dataclass(frozen=True, slots=True)
class Collided(Happening):
    """The first collision of two bodies, just before or just after it."""

    label = "collision"
    event = True

    a: str
    b: str
    after: bool

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Both sides of every pair's first collision."""
        del rng
        found: list[Self] = []
        for event in study.trace.events:
            if event.kind != "collision" or len(event.subjects) < 2 or not 0.0 < event.time < study.trace.stable_until:
                continue
            a, b = event.subjects[0], event.subjects[1]
            if a in words.mentions and b in words.mentions:
                found.extend(m for m in (cls(a, b, after=True), cls(a, b, after=False)) if m not in found)
        return found

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Both sides for every pair that is named."""
        for met in trace.mechanism.meetings:
            names = met.names
            if len(names) == 2 and pair(*(words.mentions.get(name, "?") for name in names)) in text:
                yield cls(*names, after=True)
                yield cls(*names, after=False)

    @property
    def subjects(self) -> tuple[str, ...]:
        """The two bodies."""
        return (self.a, self.b)

    def time(self, trace: Trace) -> float | None:
        """The time of the event."""
        both = {self.a, self.b}
        return next((e.time for e in trace.events if e.kind == "collision" and set(e.subjects) == both), None)

    def side(self, time: float) -> float:
        """Events belong to what follows them, so just before is the next smaller number."""
        return time if self.after else float(np.nextafter(time, 0.0))

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: just after the first collision of A and B."""
        both, side = self._both(words), "after" if self.after else "before"
        return (
            f"just {side} the first collision of {both}",
            f"just {side} {both} collide for the first time",
            f"immediately {side} the first collision of {both}",
        )

    def clause(self, words: Words) -> Clause | None:
        """As in: A and B first collide; when that is, is asked of one side alone."""
        return Clause(self._both(words), "do", "first collide", "first collide") if self.after else None

    def _both(self, words: Words) -> str:
        return pair(words.mentions[self.a], words.mentions[self.b])
