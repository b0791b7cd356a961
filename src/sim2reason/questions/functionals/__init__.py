"""Functionals of a motion: numbers that depend on an interval, such as a greatest speed."""

from abc import ABC, abstractmethod
from typing import ClassVar, TypeVar

from sim2reason.base.registry import Registry
from sim2reason.questions.moments import Moment
from sim2reason.questions.query import Noun
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.simulation.quantities.subjects import Subject
from sim2reason.simulation.trace import Channel, Trace


class Functional(ABC):
    """The base class of functionals: numbers of one subject that depend on the motion from its start to a moment.

    Definition:
        name, unit: the unit is canonical SI, empty for a pure number.
        kind: the kind of question that asks for the functional.
        of: the kind of subject.
        least: the smallest admissible answer, in the unit.

    Templates, with placeholders for the subject and for texts of its own, such as ``{ground}``:
        phrase: the noun phrase.
        how: a question, with ``{when}``; empty for none.
        indirect: the same question as a clause: *how far … moves*.
        center: whether the functional belongs to the centre of mass of an extended subject.

    Use in questions:
        weight: relative frequency within the kind.
        drawn_by_recipes: whether recipes ask for the functional; if not, only people do.
        needs: numbers that the subject must have and the text must state, such as ``mass``.
    """

    name: ClassVar[str]
    unit: ClassVar[str]
    kind: ClassVar[str]
    of: ClassVar[Subject]
    least: ClassVar[float]
    phrase: ClassVar[str]
    how: ClassVar[str] = ""
    indirect: ClassVar[str] = ""
    center: ClassVar[bool] = False
    weight: ClassVar[float] = 1.0
    drawn_by_recipes: ClassVar[bool] = True
    needs: ClassVar[tuple[str, ...]] = ()

    @abstractmethod
    def value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the functional of a subject from the start to a time, s, in its unit; None if it is undefined.

        What happens at that very instant belongs to it if `end` is an event's time, not if it is just before that.
        """

    def loose_value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return the value even where no question asks for it, as for an extreme at an end of the interval.

        By default `value`.
        """
        return self.value(trace, name, end)

    @abstractmethod
    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return the channels that must be certified over the whole interval."""

    def present(self, words: Words, name: str) -> bool:
        """Return whether the functional applies to a subject of the text; by default True."""
        del words, name
        return True

    def worth(self, study: SimulatedScene, name: str, end: float) -> bool:
        """Return whether the value is worth asking for and differs from that of a simpler question; by default True."""
        del study, name, end
        return True

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return the phrases for the interval that ends at a moment; empty if the functional is not asked for there."""
        del name
        return moment.stretches(words)

    def noun_phrases(self, words: Words) -> dict[str, Noun]:
        """Return the noun phrases of the functional for each subject that has it, by name."""
        mechanism, of = words.mechanism, self.of
        nouns: dict[str, Noun] = {}
        for name, subject_phrase in words.subject_phrases(of).items():
            given = all(of.gives(need, mechanism, name, words.stated_paths) for need in self.needs)
            if given and self.present(words, name):
                called = of.point(mechanism, name, subject_phrase) if self.center else subject_phrase
                fills = {of.slot: called, "when": "{when}", **words.fills(of, name), **self.placeholders(words, name)}
                phrase, how, indirect = (part.format(**fills) for part in (self.phrase, self.how, self.indirect))
                nouns[name] = Noun(phrase, how, indirect)
        return nouns

    def placeholders(self, words: Words, name: str) -> dict[str, str]:
        """Return the functional's own template placeholders and their texts; by default none."""
        del words, name
        return {}


def check_functional(name: str, member: object) -> None:
    """Raise ValueError if a functional lacks a declaration, UnitError if its unit is unknown."""
    missing = [fact for fact in ("unit", "kind", "of", "least", "phrase") if not hasattr(member, fact)]
    if missing:
        raise ValueError(f"questions.functionals: {name!r} declares no {', '.join(missing)}")
    parse_unit(str(getattr(member, "unit", "")))


FUNCTIONALS: Registry[Functional] = Registry("questions.functionals", check_functional)
F = TypeVar("F", bound=Functional)


def functional(cls: type[F]) -> type[F]:
    """Register a functional under its name."""
    FUNCTIONALS.add(cls.name, cls())
    return cls
