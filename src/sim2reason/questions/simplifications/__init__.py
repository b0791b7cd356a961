"""Misconceptions: simplified or altered motions that a solver may wrongly assume.

A question whose answer such a slip hardly changes pays for it; one whose answer it changes has a wrong answer to offer,
with its reason.
"""

from abc import ABC, abstractmethod
from collections.abc import Iterable
from typing import ClassVar, TypeVar

from sim2reason.base.registry import Registry
from sim2reason.questions.query import Query
from sim2reason.questions.study import Study
from sim2reason.scenes.dsl.mechanism import Mechanism


class Simplification(ABC):
    """The base class of misconceptions.

    Class data:
        name: under which it is registered and reported.
        reason: what is wrong, a sentence about ``{subject}``.
        part: whether it takes a part of the scene away, so that an answer which stays shows a part without bearing;
            else it is a mistake about the physics of a part that bears.
        holds: whether its subject no longer moves, so that a question about that one has no answer any more.
        misleads: whether anybody would make it, so that the answer it leads to is one that a student could give.
        sound_if_same: whether nobody errs who makes it where the answer stays what it is: an approximation that holds,
            or a choice that need not be made.
        common: whether it refuses many questions for the time that it takes, so that it is tried before the others.
    """

    name: ClassVar[str]
    reason: ClassVar[str]
    part: ClassVar[bool] = False
    holds: ClassVar[bool] = False
    misleads: ClassVar[bool] = True
    sound_if_same: ClassVar[bool] = False
    common: ClassVar[bool] = False

    @abstractmethod
    def subjects(self, query: Query, study: Study) -> Iterable[str]:
        """Return the subjects of the misconception for a query about a motion: names of parts of the mechanism.

        An empty name stands for the whole.
        """

    @abstractmethod
    def simplified(self, study: Study, subject: str, until: float) -> Study | None:
        """Return the scene with its motion under the misconception until a time, s; None if there is none."""


class ChangedMechanism(Simplification):
    """The base class of misconceptions that change the mechanism."""

    @abstractmethod
    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism under the misconception."""

    def simplified(self, study: Study, subject: str, until: float) -> Study | None:
        """Return the motion of the changed mechanism until a time, s; None if there is none."""
        return study.changed((self.name, subject), lambda mechanism: self.changed(mechanism, subject), until)


class OtherReading(Simplification):
    """The base class of misconceptions that misinterpret the recorded motion as a whole."""

    @abstractmethod
    def read(self, study: Study) -> Study | None:
        """Return the misinterpreted motion, over the recorded time; None if there is none."""

    def simplified(self, study: Study, subject: str, until: float) -> Study | None:
        """Return the misinterpreted motion."""
        del subject, until
        return study.once(("reading", self.name), lambda: self.read(study))


S = TypeVar("S", bound=Simplification)
SIMPLIFICATIONS: Registry[Simplification] = Registry("questions.simplifications")


def in_order() -> list[Simplification]:
    """Return all misconceptions, the common ones first."""
    return sorted(SIMPLIFICATIONS.values(), key=lambda each: not each.common)


def simplification(cls: type[S]) -> type[S]:
    """Register a misconception under its name."""
    SIMPLIFICATIONS.add(cls.name, cls())
    return cls
