"""Questions: a mode says what is unknown, a kind says at which point of the motion it is asked."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from sim2reason.dsl.mechanism import Mechanism
from sim2reason.questions.moments import Moment
from sim2reason.questions.targets import Target
from sim2reason.registry import Registry
from sim2reason.simulation.trace import Trace


@dataclass(frozen=True, slots=True)
class Query:
    """What is asked, without words: a quantity of a subject (None: the time itself) at a moment."""

    kind: str
    target: Target | None
    moment: Moment

    def time(self, trace: Trace) -> float | None:
        """When it is asked about, in seconds; None if that moment does not come in this motion."""
        return self.moment.time(trace)

    def answer(self, trace: Trace) -> float | None:
        """The value in SI units; None if the moment does not come, NaN if the mechanism leaves it open."""
        return self.answer_at(self.time(trace), trace)

    def answer_at(self, time: float | None, trace: Trace) -> float | None:
        """The same where it is already known when the moment comes."""
        if time is None or self.target is None:
            return time
        return self.target.value(trace.sample(np.array([self.moment.side(time)])))


@dataclass(frozen=True, slots=True)
class Words:
    """What a question needs to know of the text before it: how bodies are called, and how the motion begins."""

    mentions: dict[str, str]  # by address
    released: bool  # from rest; else the text counts time from t = 0


@dataclass(frozen=True, slots=True)
class Question:
    """A question in words with its answer.

    `sign` is the sense that counts as positive, in words; empty for a magnitude.
    """

    mode: str
    ask: Query
    text: str
    answer: float
    unit: str
    sign: str = ""


class Kind(Protocol):
    """One kind of question; each has a module of its own."""

    def draw(self, trace: Trace, words: Words, targets: dict[str, Target], rng: np.random.Generator) -> Query | None:
        """Something to ask about this motion, or None if it offers nothing of this kind."""
        ...

    def shapes(self, ask: Query, words: Words, noun: str) -> tuple[str, ...]:
        """All sentences that ask it, the most usual first; `noun` is the phrase for its target."""
        ...


Mode = Callable[[Trace, Words, str, np.random.Generator], Question | None]
"""Asks one question of a kind, or of any kind if that is empty."""

KINDS: Registry[Kind] = Registry("questions.kinds")
MODES: Registry[Mode] = Registry("questions.modes")

__all__ = ["KINDS", "MODES", "Kind", "Mechanism", "Mode", "Moment", "Query", "Question", "Target", "Words"]
