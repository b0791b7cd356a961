"""What is counted."""

from abc import abstractmethod
from collections.abc import Sequence
from typing import ClassVar

from sim2reason.questions.functionals import Functional
from sim2reason.questions.moments import Moment
from sim2reason.questions.moments.bounces import Bounced
from sim2reason.questions.moments.collisions import Collided
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.trace import Trace

MOST = 12  # that are worth counting
CLEAR = 0.03  # of the stretch: how far its end must be from what is counted, unless that is the end itself


class EventCount(Functional):
    """How often something happens from the start to a moment, that moment included.

    Class data:
        fewest: from how many on it is asked; two is what most people would guess.
    """

    kind, unit, least = "count", "", 1.5
    fewest: ClassVar[int] = 3

    @abstractmethod
    def times(self, trace: Trace, name: str) -> Sequence[float]:
        """When it happens, s, in order."""

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Not of a stretch that ends with a collision by its number, which may tell the answer."""
        return () if isinstance(moment, Collided | Bounced) else super().when(moment, words, name)

    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """How many there are."""
        return float(sum(time <= end for time in self.times(trace, name)))

    def worth(self, study: Study, name: str, end: float) -> bool:
        """Whether there are some, and none where no one could tell by stated numbers whether it counts."""
        times = self.times(study.trace, name)
        near = any(0.0 < abs(time - end) < CLEAR * end for time in times)
        return self.fewest <= (self.value(study.trace, name, end) or 0.0) <= MOST and not near
