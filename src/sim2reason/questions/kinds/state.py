"""What is the quantity at a stated time?"""

import numpy as np

from sim2reason.questions import KINDS, Query, Target, Words
from sim2reason.questions.choices import apart, pick
from sim2reason.questions.moments import AtTime, spoken
from sim2reason.questions.phrasing import asking_then
from sim2reason.simulation.trace import Trace

EARLIEST, LATEST = 0.15, 0.95  # of the stretch that can be asked about


class StateKind:
    """A drawn quantity at a drawn time of two digits."""

    def draw(self, trace: Trace, words: Words, targets: dict[str, Target], rng: np.random.Generator) -> Query | None:
        """A time away from events, and a quantity that changes over the motion."""
        del words
        target = pick(targets, rng)
        moment = AtTime(spoken(rng.uniform(EARLIEST, LATEST) * trace.stable_until))
        if target is None or moment.time(trace) is None or not apart(moment.after, trace):
            return None
        return Query("state", target, moment)

    def shapes(self, ask: Query, words: Words, noun: str) -> tuple[str, ...]:
        """As in: what is the speed of A 0.80 s after release?"""
        return asking_then(ask, words, noun)


KINDS.add("state", StateKind())
