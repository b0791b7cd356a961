"""Functionals of a motion: numbers that a whole stretch of it has, such as a greatest speed."""

from abc import ABC, abstractmethod
from typing import ClassVar, TypeVar

from sim2reason.base.registry import Registry
from sim2reason.questions.moments import Moment
from sim2reason.questions.query import Noun
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.units import parse_unit
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.quantities.subjects import Subject
from sim2reason.simulation.trace import Trace


class Functional(ABC):
    """A number of one subject that the motion has from its start to a moment. All that is known of it is on its class.

    What it is:
        name, unit: the unit is canonical SI, empty for a pure number.
        kind: the kind of question that asks for it.
        of: the kind of subject that it belongs to.
        least: the smallest answer that is one, in the unit.

    How it is phrased; templates name the subject by its slot, and may use what it fills besides, such as ``{ground}``:
        phrase: the noun phrase.
        how: a question of its own, with ``{when}``; none if empty.
        indirect: the same as a clause: *how far … moves*.
        center: whether it belongs to one point of its subject, the centre of mass of what has a size.

    When it is asked:
        weight: how often, compared with others of its kind.
        drawn_by_recipes: whether recipes ask for it; if not, only people do.
        needs: what its subject must have and the text must say, such as ``mass``.
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
        """Return the number from the start to a time, s, which a motion of a subject has; None if it has none.

        What happens at that very instant belongs to it if `end` is an event's time, not if it is just before that.
        """

    def loose_value(self, trace: Trace, name: str, end: float) -> float | None:
        """Return what a reader takes for it even where none would be asked for; by default the value."""
        return self.value(trace, name, end)

    @abstractmethod
    def channels(self, mechanism: Mechanism, name: str) -> tuple[Channel, ...]:
        """Return what both engines must agree on all the while."""

    def present(self, words: Words, name: str) -> bool:
        """Return whether a subject of the text can have it; so by default."""
        del words, name
        return True

    def worth(self, study: Study, name: str, end: float) -> bool:
        """Whether it is worth asking for, and is not read off what a simpler question asks for; so by default."""
        del study, name, end
        return True

    def when(self, moment: Moment, words: Words, name: str) -> tuple[str, ...]:
        """Return how a question speaks of the stretch that a moment ends; empty if that ends none of this."""
        del name
        return moment.stretches(words)

    def asked(self, words: Words) -> dict[str, Noun]:
        """By name, the subjects for which a text can ask it, each with how it does."""
        mechanism, of = words.mechanism, self.of
        found: dict[str, Noun] = {}
        for name, said in words.called(of).items():
            given = all(of.gives(need, mechanism, name, words.said) for need in self.needs)
            if given and self.present(words, name):
                called = of.point(mechanism, name, said) if self.center else said
                fills = {of.slot: called, "when": "{when}", **words.fills(of, name), **self.own(words, name)}
                phrase, how, indirect = (part.format(**fills) for part in (self.phrase, self.how, self.indirect))
                found[name] = Noun(phrase, how, indirect)
        return found

    def own(self, words: Words, name: str) -> dict[str, str]:
        """Return what placeholders of its own stand for; by default it has none."""
        del words, name
        return {}


def check_functional(name: str, member: object) -> None:
    """Refuse a functional that leaves a fact of its class open, with ValueError; UnitError for an unknown unit."""
    missing = [fact for fact in ("unit", "kind", "of", "least", "phrase") if not hasattr(member, fact)]
    if missing:
        raise ValueError(f"questions.functionals: {name!r} declares no {', '.join(missing)}")
    parse_unit(str(getattr(member, "unit", "")))


FUNCTIONALS: Registry[Functional] = Registry("questions.functionals", check_functional)
F = TypeVar("F", bound=Functional)


def functional(cls: type[F]) -> type[F]:
    """Enter a functional under its name."""
    FUNCTIONALS.add(cls.name, cls())
    return cls
