"""What is the quantity just after the start?"""

import numpy as np

from sim2reason.questions import KINDS, Query, Target, Words
from sim2reason.questions.choices import immediate, pick
from sim2reason.questions.moments import AtStart
from sim2reason.questions.phrasing import asking_then
from sim2reason.simulation.trace import Trace


class StartKind:
    """Accelerations and forces at t = 0⁺, which the text does not give."""

    def draw(self, trace: Trace, words: Words, targets: dict[str, Target], rng: np.random.Generator) -> Query | None:
        """A quantity that can differ from zero before anything has moved."""
        del words
        mechanism = trace.mechanism
        if not (mechanism.lines or mechanism.contacts):
            return None  # what only falls has the acceleration that the text gives it
        target = pick(immediate(targets), rng)
        return Query("start", target, AtStart()) if target is not None else None

    def shapes(self, ask: Query, words: Words, noun: str) -> tuple[str, ...]:
        """As in: find the tension in the string just after release."""
        return asking_then(ask, words, noun)


KINDS.add("start", StartKind())
