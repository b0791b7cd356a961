"""Regimes: assumptions about a motion, which need not hold with other numbers.

A formula holds in one of them; where the numbers of a text are symbols, the question says which one it means.
"""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar, Self

from sim2reason.base.registry import Registry
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.simulation.quantities.subjects import Subject

MAX_ASSUMPTIONS = 2  # greatest number of assumptions in one question


@dataclass(frozen=True, slots=True)
class Regime(ABC):
    """The base class of regimes: assumptions about one subject, up to the time of the answer or at the start.

    Class data:
        of: the kind of subject.
        at_start: whether the assumption concerns the initial positions only.
        stage: the time of the clause: the start (0), the whole interval (1) or its end (2).
        unseen: whether the regime may end without a change of sign in a formula; its `margin` then shows the end.
    """

    of: ClassVar[Subject]
    at_start: ClassVar[bool] = False
    unseen: ClassVar[bool] = False
    stage: ClassVar[int] = 1

    name: str

    @classmethod
    @abstractmethod
    def possible(cls, study: SimulatedScene, words: Words) -> Sequence[Self]:
        """Return the regimes of this class that motions of a scene may be in, for subjects that the text can name."""

    @abstractmethod
    def holds(self, study: SimulatedScene, until: float) -> bool:
        """Return whether the assumption holds in a motion up to a time, s."""

    def must_be_stated(self, study: SimulatedScene) -> bool:
        """Return whether every formula must state the assumption, whatever the scene's numbers; False by default."""
        del study
        return False

    def regardless_of(self, study: SimulatedScene, path: str) -> bool:
        """Return whether a number cannot affect the assumption; by default True for assumptions about the start."""
        del study, path
        return self.at_start

    def may_remove_answer(self, study: SimulatedScene) -> bool:
        """Return whether a motion may have no answer because the assumption fails in it; False by default."""
        del study
        return False

    def never_holds(self, study: SimulatedScene) -> bool:
        """Return whether a motion is known to violate the assumption up to every time, in it or after it.

        For a quick refusal; by default False.
        """
        del study
        return False

    def margin(self, study: SimulatedScene, until: float) -> float | None:
        """Return how far a motion is from violating the assumption up to a time, s, relative to the effect of weights.

        The unit is arbitrary, as only changes of the value matter. By default None.
        """
        del study, until

    @abstractmethod
    def clause(self, words: Words) -> str:
        """Return the assumption as a clause for use after *assume that*."""

    def short_clause(self, words: Words) -> str:
        """Return the clause without a part that another regime may imply; by default unchanged."""
        return self.clause(words)

    def clause_beside(self, words: Words, others: Sequence["Regime"]) -> str:
        """Return the clause beside others, which may imply a part of it; by default unchanged."""
        del others
        return self.clause(words)


REGIMES: Registry[type[Regime]] = Registry("questions.regimes")


def possible(study: SimulatedScene, words: Words) -> list[Regime]:
    """Return all regimes that motions of a scene may be in."""
    return [regime for cls in REGIMES.values() for regime in cls.possible(study, words)]


def regimes(study: SimulatedScene, words: Words, until: float) -> list[Regime]:
    """Return all regimes that a motion is in up to a time, s."""
    return [regime for regime in possible(study, words) if regime.holds(study, until)]
