"""What is the quantity when something happens for the first time?"""

import numpy as np

from sim2reason.questions import KINDS, Query, Target, Words
from sim2reason.questions.choices import happenings, pick
from sim2reason.questions.moments import Moved
from sim2reason.questions.phrasing import asking_then
from sim2reason.simulation.trace import Trace


class EventKind:
    """A collision, a body that comes to rest, or one that has moved a stated distance."""

    def draw(self, trace: Trace, words: Words, targets: dict[str, Target], rng: np.random.Generator) -> Query | None:
        """An event of this motion and a quantity that it bears on."""
        found = happenings(trace, words, rng)
        if not found:
            return None
        moment = found[int(rng.integers(len(found)))]
        offered = targets
        if isinstance(moment, Moved):  # how far it is then, the question itself says
            offered = {
                p: t for p, t in offered.items() if not (t.quantity == "displacement" and t.subject == moment.body)
            }
        else:
            offered = {p: t for p, t in offered.items() if t.subject in moment.subjects} or offered
        target = pick(offered, rng)
        return Query("event", target, moment) if target is not None else None

    def shapes(self, ask: Query, words: Words, noun: str) -> tuple[str, ...]:
        """As in: what is the speed of B when A is first 0.50 m from its starting point?"""
        return asking_then(ask, words, noun)


KINDS.add("event", EventKind())
