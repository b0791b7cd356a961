"""Base classes of moments that are events of the engines, with their verbs."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice
from typing import ClassVar, Self

import numpy as np

from sim2reason.questions.choices import REST_SPEED_RTOL, rest_speed
from sim2reason.questions.moments import Clause, Happening
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words, numbers_of, ordinal_word
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.quantities.subjects import Subject
from sim2reason.simulation.quantities.subjects.interactions import Contacts
from sim2reason.simulation.trace import Event, Trace


def when_phrases(statement: str) -> tuple[str, str, str]:
    """Return the phrases for the moment of a statement, such as *when it stops* and *at the moment when it stops*."""
    return f"when {statement}", f"at the moment when {statement}", f"at the instant at which {statement}"


@dataclass(frozen=True, slots=True)
class Verb:
    """The verb of an event, as a statement and as a question: *goes slack*, *does … go slack*."""

    told: str
    asked: str
    auxiliary: str = "does"

    def phrases(self, subject: str, number: int | None) -> tuple[str, ...]:
        """Return phrases such as *when A stops*; `number` counts repeated events and is None for a unique one."""
        if number == 1:
            first = f"{subject} first {self.told}"
            return (f"when {first}", f"at the moment when {first}", f"when {self._counted_phrase(subject, 1)}")
        happens = f"{subject} {self.told}" if number is None else self._counted_phrase(subject, number)
        return when_phrases(happens)

    def sided(self, subject: str, number: int | None, *, after: bool) -> tuple[str, ...]:
        """Return phrases such as *just after A stops*; `number` is None for a unique event."""
        side = "after" if after else "before"
        again = f"{subject} {self.told}" if number is None else self._counted_phrase(subject, number)
        return (
            f"just {side} {subject} first {self.told}" if number == 1 else f"at the moment just {side} {again}",
            f"just {side} {again}",
            f"immediately {side} {again}",
        )

    def clause(self, subject: str, number: int | None) -> Clause:
        """Return the clause for use after *how long after …*."""
        if number == 1:
            return Clause(subject, self.auxiliary, f"first {self.asked}", f"first {self.told}")
        times = "" if number is None else f" for the {ordinal_word(number)} time"
        return Clause(subject, self.auxiliary, self.asked + times, self.told + times)

    def _counted_phrase(self, subject: str, number: int) -> str:
        return f"{subject} {self.told} for the {ordinal_word(number)} time"


class VerbHappening(Happening):
    """The base class of events with a subject and a verb.

    Class data:
        verb: the verb of the event.
    """

    verb: ClassVar[Verb]

    def does(self, words: Words) -> Verb:
        """Return the verb of the event."""
        del words
        return self.verb


@dataclass(frozen=True, slots=True)
class Occurrence(VerbHappening):
    """The base class of events recorded by the engines, each with a subject and a number.

    Class data:
        kinds: the kinds of events of the engines.
        of: the kind of subject.
        most: the greatest number of a subject's event that questions ask about; 0 for a unique event.
    """

    event = True
    kinds: ClassVar[tuple[str, ...]]
    of: ClassVar[Subject]
    most: ClassVar[int] = 1

    name: str
    number: int = 1

    @classmethod
    def found(cls, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return the moments of each subject's events in the motion, up to the greatest number that is asked for."""
        del rng
        happened = {name for event in study.trace.events if event.kind in cls.kinds for name in event.subjects}
        if not happened:
            return []
        named = [name for name in cls.candidates(words) if happened & cls.seen_as(name, words)]
        all_of_them = (moment for name in named for moment in cls.each(name))
        return [moment for moment in all_of_them if study.time(moment) is not None]

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield every subject that a sentence names, with every ordinal."""
        del trace
        numbers = set(numbers_of(text))
        for name, phrase in cls.candidates(words).items():
            if phrase in text:
                yield from (m for m in cls.each(name, max(numbers)) if not cls.most or m.number in numbers)

    @classmethod
    def each(cls, name: str, last: int = 1) -> Iterator[Self]:
        """Yield the first, second, … moment of one subject, up to number `most` or, if greater, `last`."""
        return (cls(name, number) for number in range(1, max(cls.most, last if cls.most else 1) + 1))

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the possible subjects, with their phrases."""
        return dict(words.subject_phrases(cls.of))

    @classmethod
    def seen_as(cls, name: str, words: Words) -> set[str]:
        """Return the names under which the trace records events of a subject."""
        del words
        return {name}

    @property
    def subjects(self) -> tuple[str, ...]:
        """Return the name of the subject."""
        return (self.name,)

    def is_this(self, event: Event, trace: Trace) -> bool:
        """Return whether an event has this kind and subject."""
        del trace
        return event.kind in self.kinds and event.subjects[0] == self.name

    def time(self, trace: Trace) -> float | None:
        """Return the time of the event, s; None if it does not occur."""
        events = (e for e in trace.events if 0.0 < e.time <= trace.stable_until and self.is_this(e, trace))
        event = next(islice(events, self.number - 1, None), None)
        return event.time if event is not None else None

    def subject(self, words: Words) -> str:
        """Return the phrase for the subject."""
        return words.subject_phrases(self.of)[self.name]

    def count(self, words: Words) -> int | None:
        """Return the event's number among those of its subject; None if it is unique."""
        del words
        return self.number if self.most else None

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *when the string first goes slack*."""
        return self.does(words).phrases(self.subject(words), self.count(words))

    def clause(self, words: Words) -> Clause | None:
        """Return the clause, such as *the string first goes slack*."""
        return self.does(words).clause(self.subject(words), self.count(words))


@dataclass(frozen=True, slots=True)
class VelocityJump(Occurrence):
    """The base class of events at which velocities jump, so that questions name a side."""

    own = True
    after: bool = True

    @classmethod
    def each(cls, name: str, last: int = 1) -> Iterator[Self]:
        """Yield each moment twice: just before and just after the event."""
        for number in range(1, max(cls.most, last if cls.most else 1) + 1):
            yield cls(name, number, after=True)
            yield cls(name, number, after=False)

    @property
    def sided(self) -> bool | None:
        """Return True for just after the event, False for just before."""
        return self.after

    def phrases(self, words: Words) -> tuple[str, ...]:
        """Return the phrases for the moment, such as *just after the ball first hits the ground*."""
        return self.does(words).sided(self.subject(words), self.count(words), after=self.after)

    def clause(self, words: Words) -> Clause | None:
        """Return a clause such as *the ball first hits the ground* for the moment just after the event; else None."""
        return self.does(words).clause(self.subject(words), self.count(words)) if self.after else None

    def stretches(self, words: Words) -> tuple[str, ...]:
        """Return phrases such as *from release until just after the ball hits the ground for the second time*."""
        after = self.phrases(words)[1]
        return (
            f"from {words.since} until {after}",
            f"between {words.since} and the moment {after}",
            f"in the time from {words.since} to the moment {after}",
        )


@dataclass(frozen=True, slots=True)
class SlipChange(Occurrence):
    """The base class of changes between sticking and slipping on a face."""

    own = True
    of = Contacts()

    def slipped(self, event: Event, trace: Trace) -> bool:
        """Return whether the body slips shortly before an event, even if its slip only changes direction there."""
        slips = np.abs(slip_velocity(trace.scan, self.name))
        before = slips[trace.scan.times < event.time - REST_SPEED_RTOL * trace.scan.times[-1]]
        return len(before) > 0 and float(before[-1]) > rest_speed(trace, slips)


def slip_velocity(state: State, name: str) -> Array:
    """Return the velocity of slip of a body on its face, m/s, (n,)."""
    mechanism = state.mechanism
    total = np.zeros(len(state.times))
    for coordinate, factor in mechanism.contacts[name].slip:
        total = total + factor * state.v[:, mechanism.number[coordinate]]
    return total


def can_roll(words: Words, name: str) -> bool:
    """Return whether a body on a face can rotate, so that it may roll rather than slide."""
    return len(words.mechanism.contacts[name].slip) > 1
