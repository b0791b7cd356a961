"""Misconceptions: what a solver may wrongly leave out of a motion, or take to be simpler than it is.

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
    """One slip. All that the library knows of it stands on its class.

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
        """Return what it can be about where a query asks about a motion: names of the mechanism's parts.

        An empty name stands for the whole.
        """

    @abstractmethod
    def simplified(self, study: Study, subject: str, until: float) -> Study | None:
        """Return the scene as the slip has it, with its motion until a time, s; None if there is none."""


class ChangedMechanism(Simplification):
    """A slip that amounts to another mechanism."""

    @abstractmethod
    def changed(self, mechanism: Mechanism, subject: str) -> Mechanism:
        """Return the mechanism as the slip has it."""

    def simplified(self, study: Study, subject: str, until: float) -> Study | None:
        """Return the motion of that mechanism."""
        return study.changed((self.name, subject), lambda mechanism: self.changed(mechanism, subject), until)


class OtherReading(Simplification):
    """A slip that reads the same motion differently, as a whole."""

    @abstractmethod
    def read(self, study: Study) -> Study | None:
        """Return the motion as the slip has it, for as long as it is recorded; None if there is none."""

    def simplified(self, study: Study, subject: str, until: float) -> Study | None:
        """Return that motion."""
        del subject, until
        return study.once(("reading", self.name), lambda: self.read(study))


S = TypeVar("S", bound=Simplification)
SIMPLIFICATIONS: Registry[Simplification] = Registry("questions.simplifications")


def in_order() -> list[Simplification]:
    """Return all slips, the common ones first."""
    return sorted(SIMPLIFICATIONS.values(), key=lambda each: not each.common)


def simplification(cls: type[S]) -> type[S]:
    """Enter a slip under its name."""
    SIMPLIFICATIONS.add(cls.name, cls())
    return cls
