"""Misconceptions: simplified or altered motions that a solver may wrongly assume.

A question whose answer such a slip hardly changes pays for it; one whose answer it changes has a wrong answer to offer,
with its reason.
"""

from abc import ABC, abstractmethod
from collections.abc import Iterable
from functools import lru_cache
from typing import ClassVar, TypeVar

from sim2reason.base.registry import Registry
from sim2reason.questions.query import Query
from sim2reason.questions.study import SimulatedScene
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.structure import fix_body


class Misconception(ABC):
    """The base class of misconceptions.

    Class data:
        name: the registered name, which reports use.
        reason: a statement of the error, with the placeholder ``{subject}``.
        part: whether a part of the scene is removed, so that an unchanged answer shows that the part is irrelevant;
            if not, the physics of a relevant part is wrong.
        holds: whether the subject no longer moves, so that questions about it have no answer.
        misleads: whether students make the error, so that its answer is a plausible distractor.
        sound_if_same: whether the assumption is correct if the answer is unchanged, as a valid approximation is.
        common: whether the misconception rejects many questions at little cost, so that it is tried first.
    """

    name: ClassVar[str]
    reason: ClassVar[str]
    part: ClassVar[bool] = False
    holds: ClassVar[bool] = False
    misleads: ClassVar[bool] = True
    sound_if_same: ClassVar[bool] = False
    common: ClassVar[bool] = False

    @abstractmethod
    def subjects(self, query: Query, study: SimulatedScene) -> Iterable[str]:
        """Return the subjects of the misconception for a query about a motion: names of parts of the mechanism.

        An empty name denotes the whole mechanism.
        """

    @abstractmethod
    def simplified(self, study: SimulatedScene, subject: str, until: float) -> SimulatedScene | None:
        """Return the scene with its motion under the misconception until a time, s; None if there is none."""


class ChangedMechanism(Misconception):
    """The base class of misconceptions that change the mechanism."""

    @abstractmethod
    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism under the misconception."""

    @property
    def change(self) -> str:
        """Return the name of the change; misconceptions with the same change of a subject share its motions."""
        return self.name

    def simplified(self, study: SimulatedScene, subject: str, until: float) -> SimulatedScene | None:
        """Return the motion of the changed mechanism until a time, s; None if there is none."""
        return study.changed((self.change, subject), lambda mechanism: self.changed(mechanism, subject), until)


class FixedBody(ChangedMechanism):
    """The base class of misconceptions in which a moving body is taken to be fixed to what carries it."""

    @property
    def change(self) -> str:
        """Return the name of the change, common to all of them."""
        return "fixed body"

    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism with the body fixed to its carrier."""
        return fix_body(mechanism, subject)


class MisinterpretedMotion(Misconception):
    """The base class of misconceptions that misinterpret the recorded motion as a whole."""

    @abstractmethod
    def read(self, study: SimulatedScene) -> SimulatedScene | None:
        """Return the misinterpreted motion, over the recorded time; None if there is none."""

    def simplified(self, study: SimulatedScene, subject: str, until: float) -> SimulatedScene | None:
        """Return the misinterpreted motion."""
        del subject, until
        return study.memoize(("reading", self.name), lambda: self.read(study))


S = TypeVar("S", bound=Misconception)
MISCONCEPTIONS: Registry[Misconception] = Registry("questions.simplifications")


def ordered_misconceptions() -> tuple[Misconception, ...]:
    """Return all misconceptions, the common ones first."""
    return _ordered(tuple(MISCONCEPTIONS.values()))


@lru_cache(maxsize=4)  # the registry may grow
def _ordered(misconceptions: tuple[Misconception, ...]) -> tuple[Misconception, ...]:
    return tuple(sorted(misconceptions, key=lambda each: not each.common))


def misconception(cls: type[S]) -> type[S]:
    """Register a misconception under its name."""
    MISCONCEPTIONS.add(cls.name, cls())
    return cls
