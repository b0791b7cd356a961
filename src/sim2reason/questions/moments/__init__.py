"""Moments of a motion: a time, the start, or the first time that something happens."""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import ClassVar, Self

import numpy as np

from sim2reason.base.registry import Registry
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.trace import Trace


class Moment(ABC):
    """A point of a motion; a subclass is a frozen dataclass. All that the library knows of it stands on its class.

    Class data:
        kind: the kind of question that asks for quantities at it.
        label: what items record as `asked.event`; None for a time that is stated.
        drawn_by_recipes: whether recipes ask about it; if not, only people do.
        event: whether it is an event of the engines, which both must see; else its channels must be certified.
        own: whether it is of its own subjects that quantities are asked at it first, as at a collision.
        pronoun: what may stand for its `subject` in a sentence that has named it.
        part: whether that subject may be the centre of a body, by whose name alone it is known, too.
    """

    kind: ClassVar[str]
    label: ClassVar[str | None]
    drawn_by_recipes: ClassVar[bool] = True
    event: ClassVar[bool] = False
    own: ClassVar[bool] = False
    pronoun: ClassVar[str] = "it"
    part: ClassVar[bool] = False

    @property
    def subjects(self) -> tuple[str, ...]:
        """The names of what it speaks of, bodies, lines or pairs; none by default."""
        return ()

    def possible(self, mechanism: Mechanism) -> bool:
        """Tell whether a mechanism has what it speaks of, as an arm that is held does not swing; by default so."""
        del mechanism
        return True

    @property
    def channels(self) -> tuple[Channel, ...]:
        """Return what both engines must agree on for it to be certain; nothing by default."""
        return ()

    @property
    def stated(self) -> tuple[tuple[float, str], ...]:
        """The numbers that a question about it says, each with its unit; none by default."""
        return ()

    def having(self, numbers: Sequence[float]) -> Self:
        """Return the same moment with other numbers in place of those that are `stated`; by default there are none."""
        del numbers
        return self

    def across(self, trace: Trace) -> Sequence[float] | None:
        """What is `stated`, on the other side of where it starts; None, as by default, if there is one side alone."""
        del trace
        return None

    @property
    def tells(self) -> tuple[Channel, ...]:
        """Return what its own words say, which therefore can't be asked; nothing by default."""
        return ()

    @property
    def ahead(self) -> float | None:
        """Return a moment's stated time, s, or 0 for the start; None if the motion determines the time."""
        if self.event or self.channels:
            return None
        return next((time for time, _ in self.stated), 0.0 if self.kind == "start" else None)

    @property
    def comes_round(self) -> bool:
        """Return whether it never comes where one of its bodies flies off for ever; by default it may."""
        return False

    @classmethod
    @abstractmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return those of a motion that are worth asking about."""

    @classmethod
    @abstractmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Return all that a sentence could speak of, by the numbers and names that stand in it."""

    @abstractmethod
    def time(self, trace: Trace) -> float | None:
        """Return when it comes, in seconds; None if it does not come while the motion is described."""

    @abstractmethod
    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return how a question speaks of it, *when …*."""

    def stretches(self, words: Words) -> tuple[str, ...]:
        """Return how a question speaks of the stretch from the start to it; empty, as by default, if it does not."""
        del words
        return ()

    def first(self) -> "Moment":
        """The same moment, told without what comes after it, where a question calls it the first; by default this."""
        return self

    def in_symbols(self, trace: Trace) -> "Moment":
        """Return the same moment of a motion, as a text must tell it whose symbols leave more open; by default this."""
        del trace
        return self

    def subject(self, words: Words) -> str:
        """Return how a question calls the one that it is about; by default it is about nothing."""
        del words
        return ""

    @property
    def sided(self) -> bool | None:
        """Return whether it is just after (True) or just before (False) what happens; None if its words say neither."""
        return None

    def side(self, time: float) -> float:
        """Return the instant at which quantities are read: the moment itself, or just before it."""
        return float(np.nextafter(time, 0.0)) if self.sided is False else time  # events belong to what follows them


@dataclass(frozen=True, slots=True)
class Clause:
    """Something that happens, as a question and as a statement: *does A first stop*, *A first stops*.

    What takes time says so, too: *to move 0.50 m*.
    """

    subject: str
    auxiliary: str
    asked: str
    told: str
    takes: str = ""

    @property
    def question(self) -> str:
        """After *how long after the start …*."""
        return f"{self.auxiliary} {self.subject} {self.asked}"

    @property
    def statement(self) -> str:
        """After *until …*."""
        return f"{self.subject} {self.told}"


class Happening(Moment):
    """The first time that something happens, so that it can also be asked when that is."""

    kind = "event"

    @abstractmethod
    def clause(self, words: Words) -> Clause | None:
        """Return what happens; None if when it comes is not to be asked."""

    def stretches(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the stretch, such as *from release until A first stops*."""
        clause = self.clause(words)
        if clause is None:
            return ()
        since, told = words.since, clause.statement
        return (
            f"from {since} until {told}",
            f"between {since} and the moment when {told}",
        )

    def is_plain(self, study: Study) -> bool:
        """Return whether no physics is needed to tell when it comes, so that this is not asked; by default it is."""
        del study
        return False


def check_facts(name: str, member: object) -> None:
    """Refuse a moment that leaves a fact of its class open, with ValueError."""
    missing = [fact for fact in ("kind", "label") if not hasattr(member, fact)]
    if missing:
        raise ValueError(f"questions.moments: {name!r} declares no {', '.join(missing)}")


MOMENTS: Registry[type[Moment]] = Registry("questions.moments", check_facts)
