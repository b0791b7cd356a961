"""Regimes: what is true of a motion and need not be of one with other numbers.

A formula holds in one of them; where the numbers of a text are symbols, the question says which one it means.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Self

from sim2reason.base.registry import Registry
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.quantities.subjects import Subject

FEW = 2  # that one question assumes, at most


@dataclass(frozen=True, slots=True)
class Regime(ABC):
    """Something that one subject does from the start to the time that a question is about, or as it starts.

    Class data:
        of: the kind of subject.
        at_start: whether it is of where things are at the start, whatever they are and come to do.
        stage: whether its clause is about the start (0), all the time from there on (1), or what is so at the end (2).
        unseen: whether it may end though no sum in a formula turns its sign there; then that is looked for by `margin`.
    """

    of: ClassVar[Subject]
    at_start: ClassVar[bool] = False
    unseen: ClassVar[bool] = False
    stage: ClassVar[int] = 1

    name: str

    @classmethod
    @abstractmethod
    def possible(cls, study: Study, words: Words) -> Sequence[Self]:
        """Return those that a motion of such a scene may be in, as far as the text has words for them."""

    @abstractmethod
    def holds(self, study: Study, until: float) -> bool:
        """Return whether it is so in another motion up to a time, s."""

    def always_told(self, study: Study) -> bool:
        """Return whether a formula without it can not be read, whatever the numbers of the scene; by default not."""
        del study
        return False

    def regardless_of(self, study: Study, path: str) -> bool:
        """Return whether it is of where things are at the start, whatever the number at an address is."""
        del study, path
        return self.at_start

    def is_lost(self, study: Study) -> bool:
        """Whether another motion may have no answer because it is not so at some time; by default that says nothing."""
        del study
        return False

    def margin(self, study: Study, until: float) -> float | None:
        """Return how far another motion that is in it up to a time, s, is from losing it, beside what weights do.

        In any unit, since it only says which way leads there. By default nothing tells.
        """
        del study, until

    @abstractmethod
    def clause(self, words: Words) -> str:
        """It in words, after *assume that*."""

    def short_clause(self, words: Words) -> str:
        """Return the same without what another regime may imply; by default nothing is left out."""
        return self.clause(words)

    def clause_beside(self, words: Words, others: Sequence["Regime"]) -> str:
        """Return it in words beside others that are assumed, which may imply a part of it; by default none does."""
        del others
        return self.clause(words)


REGIMES: Registry[type[Regime]] = Registry("questions.regimes")


def possible(study: Study, words: Words) -> list[Regime]:
    """Return all that motions of such a scene may be in."""
    return [found for cls in REGIMES.values() for found in cls.possible(study, words)]


def regimes(study: Study, words: Words, until: float) -> list[Regime]:
    """Return all that a motion is in, up to a time, s."""
    return [found for found in possible(study, words) if found.holds(study, until)]
