"""Moments: the start, a stated time, or the first occurrence of an event."""

from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import ClassVar, Self

import numpy as np

from sim2reason.base.registry import Registry
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.simulation.trace import Channel, Trace


class Moment(ABC):
    """The base class of moments; subclasses are frozen dataclasses.

    Class data:
        kind: the kind of question that asks for quantities at the moment.
        label: the value of `asked.event` in items; None for a stated time.
        drawn_by_recipes: whether recipes ask about the moment; if not, only people do.
        event: whether both engines must record the moment as an event; if not, its channels must be certified.
        own: whether questions prefer quantities of the moment's own subjects, as at a collision.
        pronoun: the pronoun for the `subject` in a sentence that has named it.
        part: whether the subject may be the centre of a body, which the body's name also denotes.
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
        """Return the names of the bodies, lines or pairs that the moment refers to; none by default."""
        return ()

    def possible(self, mechanism: Mechanism) -> bool:
        """Return whether a mechanism has the subjects of the moment, free to move; True by default."""
        del mechanism
        return True

    @property
    def channels(self) -> tuple[Channel, ...]:
        """Return the channels that must be certified for the moment; none by default."""
        return ()

    @property
    def stated(self) -> tuple[tuple[float, str], ...]:
        """Return the numbers that a question about the moment states, each with its unit; none by default."""
        return ()

    def having(self, numbers: Sequence[float]) -> Self:
        """Return the same moment with other `stated` numbers; by default unchanged."""
        del numbers
        return self

    def mirrored_values(self, trace: Trace) -> Sequence[float] | None:
        """Return the `stated` numbers on the opposite side of the initial value; None, as by default, without any."""
        del trace
        return None

    @property
    def revealed_channels(self) -> tuple[Channel, ...]:
        """Return the channels that the words of the moment reveal, so that none is asked for; empty by default."""
        return ()

    @property
    def stated_time(self) -> float | None:
        """Return a moment's stated time, s, or 0 for the start; None if the motion determines the time."""
        if self.event or self.channels:
            return None
        return next((time for time, _ in self.stated), 0.0 if self.kind == "start" else None)

    @property
    def requires_return(self) -> bool:
        """Return whether the moment never occurs if one of its bodies escapes to infinity; False by default."""
        return False

    @classmethod
    @abstractmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return the moments of this class in a motion that are worth asking about."""

    @classmethod
    @abstractmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield all moments of this class that a sentence may name, from its numbers and names."""

    @abstractmethod
    def time(self, trace: Trace) -> float | None:
        """Return the time of the moment, s; None if it does not occur in the simulated motion."""

    @abstractmethod
    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *when A stops*."""

    def stretches(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the interval from the start to the moment; none by default."""
        del words
        return ()

    def first(self) -> "Moment":
        """Return a form of the moment that later motion cannot shift, as *first* implies; unchanged by default."""
        return self

    def in_symbols(self, trace: Trace) -> "Moment":
        """Return the moment of a motion in a form that is unique even without numbers; by default unchanged."""
        del trace
        return self

    def subject(self, words: Words) -> str:
        """Return the phrase for the moment's subject, which a pronoun may replace; empty by default."""
        del words
        return ""

    @property
    def sided(self) -> bool | None:
        """Return True for just after an event, False for just before, None if the words name no side."""
        return None

    def evaluation_time(self, time: float) -> float:
        """Return the time, s, at which quantities are evaluated: the moment itself, or just before it."""
        return float(np.nextafter(time, 0.0)) if self.sided is False else time  # events belong to what follows them


@dataclass(frozen=True, slots=True)
class Clause:
    """The parts of a clause, as a question and as a statement: *does A first stop*, *A first stops*.

    `takes` is an infinitive for events that take time: *to move 0.50 m*.
    """

    subject: str
    auxiliary: str
    asked: str
    told: str
    takes: str = ""

    @property
    def question(self) -> str:
        """Return the clause in question order, for use after *how long after the start …*."""
        return f"{self.auxiliary} {self.subject} {self.asked}"

    @property
    def statement(self) -> str:
        """Return the clause as a statement, for use after *until …*."""
        return f"{self.subject} {self.told}"


class Happening(Moment):
    """The base class of moments whose time can itself be asked for."""

    kind = "event"

    @abstractmethod
    def clause(self, words: Words) -> Clause | None:
        """Return the clause of the event; None if no question may ask for its time."""

    def stretches(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the interval up to the moment, such as *from release until A first stops*."""
        clause = self.clause(words)
        if clause is None:
            return ()
        since, statement = words.since, clause.statement
        return (
            f"from {since} until {statement}",
            f"between {since} and the moment when {statement}",
        )

    def is_plain(self, study: SimulatedScene) -> bool:
        """Return whether the time follows without physics, so that it is not asked for; False by default."""
        del study
        return False


def check_facts(name: str, member: object) -> None:
    """Raise ValueError if a class of moments declares no question kind or no label."""
    missing = [fact for fact in ("kind", "label") if not hasattr(member, fact)]
    if missing:
        raise ValueError(f"questions.moments: {name!r} declares no {', '.join(missing)}")


MOMENTS: Registry[type[Moment]] = Registry("questions.moments", check_facts)
