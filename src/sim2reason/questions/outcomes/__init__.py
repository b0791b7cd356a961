"""Outcomes: events that occur or do not occur in a motion, with a threshold in between."""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import ClassVar, Self

import numpy as np

from sim2reason.base.registry import Registry
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.structure import changing
from sim2reason.simulation.quantities.subjects import Subject
from sim2reason.simulation.trace import Trace

ONSET_DURATION = 0.01  # of the horizon: time that shows the result of a release
SPEED_NOISE = 1e-12  # of g times the time: smaller velocities are rounding; engines leave 1e-15 for a body at rest


@dataclass(frozen=True, slots=True)
class PossibleOutcome(ABC):
    """The base class of outcomes: something that one subject does or does not do.

    Class data:
        of: the kind of subject.
        tells: the side of the threshold on which `excess` is defined: with the outcome (True) or without it.
        drawn_by_recipes: whether recipes ask about the outcome; if not, only people do.
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
        """Yield the outcome for every subject that a sentence names."""
        return (cls(name) for name, phrase in cls.candidates(words).items() if phrase in text)

    @classmethod
    @abstractmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the possible subjects, with their phrases."""

    @abstractmethod
    def duration(self, scene: Scene) -> float:
        """Return the usual duration, s, of a motion that shows the outcome."""

    @abstractmethod
    def happens(self, trace: Trace) -> bool | None:
        """Return whether the outcome occurs in a motion; None if only a longer motion can show it."""

    def excess(self, trace: Trace) -> float | None:
        """Return a number that goes to zero as the motion approaches the threshold from one side; None without one.

        It only speeds up the search; the outcome itself decides about the threshold.
        """
        del trace

    @abstractmethod
    def does(self, words: Words) -> tuple[str, ...]:
        """Return clauses that say that the outcome occurs, such as *A slips on B*."""

    @abstractmethod
    def does_not(self, words: Words) -> tuple[str, ...]:
        """Return clauses that say that the outcome does not occur, such as *A stays at rest on B*."""

    def subject(self, words: Words) -> str:
        """Return the phrase for the subject."""
        return self.candidates(words)[self.name]


@dataclass(frozen=True, slots=True)
class Swinging(PossibleOutcome):
    """The base class of outcomes of swings, which show within a few of them."""

    def duration(self, scene: Scene) -> float:
        """Return the duration, s, of a few swings: a fixed fraction of the scene's usual simulation time."""
        return scene.horizon / 4.0


@dataclass(frozen=True, slots=True)
class Onset(PossibleOutcome):
    """The base class of outcomes of a release, which show at once, as no force changes."""

    def duration(self, scene: Scene) -> float:
        """Return a short time, s, a small fraction of the scene's usual simulation time."""
        return ONSET_DURATION * scene.horizon


def rest_speed_noise(trace: Trace) -> float:
    """Return the largest apparent speed, m/s, of a body at rest in a motion."""
    return SPEED_NOISE * float(np.linalg.norm(trace.mechanism.gravity)) * float(trace.state.times[-1])


def is_steady_release(words: Words) -> bool:
    """Return whether all bodies start from rest and no force changes, so that the initial behaviour persists."""
    mechanism: Mechanism = words.mechanism
    return words.released and not changing(mechanism)


OUTCOMES: Registry[type[PossibleOutcome]] = Registry("questions.outcomes")
