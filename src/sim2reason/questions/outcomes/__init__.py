"""Outcomes: what a motion does or does not do, so that a question can ask for the threshold between the two."""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import ClassVar, Self

import numpy as np

from sim2reason.base.registry import Registry
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.constancy import changing
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.simulation.quantities.subjects import Subject
from sim2reason.simulation.trace import Trace

ONSET = 0.01  # of the horizon: how long it takes to see what a release brings about
NOTHING = 1e-12  # of g times the time: less is a slip of numbers; of what is at rest engines leave 1e-15


@dataclass(frozen=True, slots=True)
class PossibleOutcome(ABC):
    """What one subject does or does not do.

    Class data:
        of: the kind of subject.
        tells: on which side of where the outcome changes the motion tells how far that is: where it happens, or not.
        drawn_by_recipes: whether recipes ask about it; if not, only people do.
    """

    drawn_by_recipes: ClassVar[bool] = True
    of: ClassVar[Subject]
    tells: ClassVar[bool] = True

    name: str

    @classmethod
    def found(cls, words: Words) -> Sequence[Self]:
        """Return the outcomes that recipes may ask about in a scene."""
        return [cls(name) for name in cls.candidates(words)] if cls.drawn_by_recipes else ()

    @classmethod
    def parsed(cls, text: str, words: Words) -> Iterator[Self]:
        """Return every subject that is named."""
        return (cls(name) for name, phrase in cls.candidates(words).items() if phrase in text)

    @classmethod
    @abstractmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the subjects that may do it, by name, as the text calls them."""

    @abstractmethod
    def duration(self, scene: Scene) -> float:
        """Return how long a motion must be followed to see it, s, as a rule."""

    @abstractmethod
    def happens(self, trace: Trace) -> bool | None:
        """Return whether it does it in a motion of any engine; None if that must be followed for longer."""

    def excess(self, trace: Trace) -> float | None:
        """Return what goes to zero evenly towards where the outcome changes, in a motion that `tells`; by default none.

        It only saves trials: whether the outcome happens decides where it changes.
        """
        del trace

    @abstractmethod
    def does(self, words: Words) -> tuple[str, ...]:
        """Clauses that it does: *A slips on B*."""

    @abstractmethod
    def does_not(self, words: Words) -> tuple[str, ...]:
        """Clauses that it does not: *A stays at rest on B*."""

    def subject(self, words: Words) -> str:
        """Return how a question calls it."""
        return self.candidates(words)[self.name]


@dataclass(frozen=True, slots=True)
class Swinging(PossibleOutcome):
    """What swings does, so that it shows in part of a swing or in some, and is followed until it does."""

    def duration(self, scene: Scene) -> float:
        """Return a part of the horizon, which is that of some swings."""
        return scene.horizon / 4.0


@dataclass(frozen=True, slots=True)
class Onset(PossibleOutcome):
    """What a release brings about at once, or never, since no force changes."""

    def duration(self, scene: Scene) -> float:
        """Return a moment."""
        return ONSET * scene.horizon


def rest_speed_noise(trace: Trace) -> float:
    """Up to which speed what is at rest may seem to move in a motion, m/s."""
    return NOTHING * float(np.linalg.norm(trace.mechanism.gravity)) * float(trace.state.times[-1])


def is_steady_release(words: Words) -> bool:
    """Return whether all starts from rest, and what it does at first it goes on doing."""
    mechanism: Mechanism = words.mechanism
    return words.released and not changing(mechanism)


OUTCOMES: Registry[type[PossibleOutcome]] = Registry("questions.outcomes")
