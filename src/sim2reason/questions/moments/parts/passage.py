"""Moments at which something passes through a value: found on the engine's own steps."""

from abc import abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import ClassVar, Self

import numpy as np

from sim2reason.questions.choices import apart
from sim2reason.questions.crossing import first_crossing
from sim2reason.questions.moments import Clause
from sim2reason.questions.moments.parts.verbs import VerbHappening
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.state import Array, State
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.quantities.subjects import Subject
from sim2reason.simulation.trace import Trace


@dataclass(frozen=True, slots=True)
class Passage(VerbHappening):
    """The first time that a function of the motion of one subject passes through zero.

    Class data:
        of: the kind of subject.
        hangs_on: the quantity, by name, that both engines must agree on.
    """

    of: ClassVar[Subject]
    hangs_on: ClassVar[str]

    name: str

    @abstractmethod
    def excess(self, state: State) -> Array:
        """Return what is below zero before, and above zero after, (n,)."""

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return every subject that gets there, away from events."""
        del rng
        return [moment for name in cls.candidates(words) if (moment := cls(name)).comes(study)]

    def comes(self, study: Study) -> bool:
        """Return whether it happens, away from events."""
        time = study.time(self)
        return time is not None and apart(time, study.trace)

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Return every subject that is named."""
        del trace
        return (cls(name) for name, phrase in cls.candidates(words).items() if phrase in text)

    @classmethod
    def candidates(cls, words: Words) -> dict[str, str]:
        """Return the subjects that it can happen to, by name, as the text calls them."""
        return dict(words.called(cls.of))

    @property
    def subjects(self) -> tuple[str, ...]:
        """The one that it happens to."""
        return (self.name,)

    def possible(self, mechanism: Mechanism) -> bool:
        """Tell whether its subject is still one of those that it can happen to."""
        return self.name in self.of.names(mechanism)

    @property
    def channels(self) -> tuple[Channel, ...]:
        """Return what it hangs on."""
        return (Channel(self.name, self.hangs_on),)

    def time(self, trace: Trace) -> float | None:
        """Return when the function first passes through zero."""
        return first_crossing(trace, self.excess)

    def subject(self, words: Words) -> str:
        """Return how a question calls the one that it happens to."""
        return self.candidates(words)[self.name]

    def phrases(self, words: Words) -> tuple[str, ...]:
        """As in: when the ball first passes through the lowest point of its path."""
        return self.does(words).phrases(self.subject(words), 1)

    def clause(self, words: Words) -> Clause | None:
        """Return the clause, such as *the ball first passes through the lowest point of its path*."""
        return self.does(words).clause(self.subject(words), 1)


@dataclass(frozen=True, slots=True)
class Threshold(Passage):
    """The first time that a quantity of a subject has a stated value, which is drawn and spoken with two digits.

    Class data:
        unit: of the value, in the SI.
    """

    unit: ClassVar[str]

    value: float  # in the units of the text, as spoken

    @classmethod
    def found(cls, study: Study, words: Words, rng: np.random.Generator) -> Sequence[Self]:
        """Return a drawn value for one subject."""
        names = list(cls.candidates(words))
        if not names:
            return []
        name = names[int(rng.integers(len(names)))]
        value = cls.drawn(name, study.trace, rng)
        return [moment] if value is not None and (moment := cls(name, value)).comes(study) else []

    @classmethod
    @abstractmethod
    def drawn(cls, name: str, trace: Trace, rng: np.random.Generator) -> float | None:
        """Return a value that is reached, as it will be spoken; None if there is none."""

    @classmethod
    def parsed(cls, text: str, trace: Trace, words: Words) -> Iterator[Self]:
        """Yield every subject that is named, with every number of the unit."""
        del trace
        numbers = words.heard(text, cls.unit)
        for name, phrase in cls.candidates(words).items():
            if phrase in text:
                yield from (cls(name, number) for number in numbers)

    @property
    def stated(self) -> tuple[tuple[float, str], ...]:
        """The value."""
        return ((self.value, self.unit),)

    @property
    def tells(self) -> tuple[Channel, ...]:
        """The quantity, then."""
        return self.channels

    def having(self, numbers: Sequence[float]) -> Self:
        """With another value."""
        (value,) = numbers
        return replace(self, value=value)

    def said(self, words: Words) -> str:
        """Return the value with its unit."""
        return words.amount(self.value, self.unit)
