"""The first time that a body is a stated distance from its starting point."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Self

import numpy as np

from sim2reason.dsl.state import Array
from sim2reason.quantities import QUANTITIES
from sim2reason.questions.choices import apart, free_bodies, named
from sim2reason.questions.crossing import first_crossing
from sim2reason.questions.moments import MOMENTS, Clause, Happening
from sim2reason.questions.spoken import said, say, spoken
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace

NEAREST, FARTHEST = 0.2, 0.9  # of how far the body gets
SHORTEST, LONGEST = 0.01, 3.0  # m; strings are not longer


@MOMENTS.register("moved")
@dataclass(frozen=True, slots=True)
class Moved(Happening):
    """The first time that a body is a stated distance from its starting point."""

    label = "moved"

    body: str
    distance: float  # m, as spoken

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """A drawn distance for one body that gets somewhere."""
        trace, names = study.trace, free_bodies(study.mechanism, words)
        if not names:
            return []
        name = names[int(rng.integers(len(names)))]
        reached = float(_far(trace, name, np.linspace(0.0, trace.stable_until, 17)).max())
        distance = rng.uniform(NEAREST, FARTHEST) * min(reached, LONGEST)
        if distance < SHORTEST:
            return []
        moment = cls(name, spoken(distance))
        time = study.time(moment)
        return [moment] if time is not None and apart(time, trace) else []

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Every body that is named, with every number of metres."""
        return (
            cls(name, distance)
            for name in named(text, trace.mechanism, words)
            for distance in said(text, words.units.length)
        )

    @property
    def subjects(self) -> tuple[str, ...]:
        """The body."""
        return (self.body,)

    @property
    def channels(self) -> tuple[Channel, ...]:
        """How far the body gets."""
        return (Channel(self.body, "displacement"),)

    @property
    def stated(self) -> tuple[tuple[float, str], ...]:
        """The distance."""
        return ((self.distance, "m"),)

    @property
    def tells(self) -> tuple[Channel, ...]:
        """How far the body is then."""
        return (Channel(self.body, "displacement"),)

    def time(self, trace: Trace) -> float | None:
        """By scanning and halving; None if it never gets that far while the motion is described."""
        return first_crossing(lambda times: _far(trace, self.body, times) - self.distance, trace.stable_until)

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: when the block is first 0.50 m from its starting point."""
        body, distance = words.mentions[self.body], say(self.distance, words.units.length)
        return (
            f"when {body} is first {distance} from its starting point",
            f"at the moment when {body} is first {distance} from its starting point",
            f"as soon as {body} is {distance} from its starting point",
        )

    def clause(self, words: Words) -> Clause | None:
        """As in: the block is first 0.50 m from its starting point."""
        there = f"first {say(self.distance, words.units.length)} from its starting point"
        return Clause(words.mentions[self.body], "is", there, f"is {there}")


def _far(trace: Trace, body: str, times: Array) -> Array:
    """The distance from the starting point at `times`, (n,)."""
    return np.linalg.norm(QUANTITIES["displacement"].evaluate(trace.sample(times), body), axis=1)
