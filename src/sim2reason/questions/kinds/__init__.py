"""Kinds of questions: what each asks of a motion, its sentences and its answers."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from math import inf, isfinite
from typing import ClassVar, TypeVar

import numpy as np

from sim2reason.base.registry import Registry
from sim2reason.questions.accuracy import certification_gap
from sim2reason.questions.choices import data_relevant_from, has_collided
from sim2reason.questions.moments import MOMENTS, Moment
from sim2reason.questions.moments.reached import moment_of
from sim2reason.questions.phrasing import asking_then, naming_then, stating_then
from sim2reason.questions.query import Noun, Query, Targets, quantities_named, target_named
from sim2reason.questions.structured import EQUILIBRIUM, StructuredQuestion
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.simulation.certify import Certificate
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import EVENT_TIME_RTOL, Channel


@dataclass(frozen=True, slots=True)
class Measured:
    """The quantity, unit and smallest admissible value of an answer.

    What is `whole` is counted: its answer is a whole number, and only that is right.
    """

    name: str
    unit: str
    least: float
    whole: bool = False


class Kind(ABC):
    """The base class of question kinds.

    Class data:
        name: under which it is registered.
        share: relative frequency among all kinds; positive.
        of_symbols: whether the answer is a function of the text's symbols alone.
        whole: whether answers are integers.
        awaited: whether the answer depends on an unnamed later time of the motion, such as its period.
        derivable: whether questions require a worked solution without integration.
        costly: whether the kind is drawn by its share only, never as a substitute, as it needs many simulations.
        beyond_laws: whether a solution needs more than laws and formulas, such as a derivative or a limit.
        hides: whether questions leave a number of the text open.
        names_one: whether answers name one of two candidates besides a number, so that they need options.
    """

    name: ClassVar[str]
    share: ClassVar[float]
    of_symbols: ClassVar[bool] = True
    whole: ClassVar[bool] = False
    awaited: ClassVar[bool] = False
    derivable: ClassVar[bool] = False
    costly: ClassVar[bool] = False
    beyond_laws: ClassVar[bool] = False
    hides: ClassVar[bool] = False
    names_one: ClassVar[bool] = False

    @property
    def stated(self) -> bool:
        """Return whether the kind has noun phrases for its answers, so that a condition can state an answer."""
        return type(self).noun_phrases is not Kind.noun_phrases

    @property
    def takes_likely_answer(self) -> bool:
        """Return whether a likely answer speeds up the search for the answer."""
        return type(self).with_likely_answer is not Kind.with_likely_answer

    def of_motion(self, query: Query) -> bool:
        """Return whether an answer may depend on the initial motion; by default True."""
        del query
        return True

    @abstractmethod
    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a random query of this kind about a motion; None if there is none."""

    def at(
        self, moment: Moment, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Return a query of this kind at another question's moment; None, as by default, if there is none."""
        del moment, study, words, targets, rng
        return None

    @abstractmethod
    def answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the answer in SI units; None if the moment does not occur, NaN if the mechanism leaves it open."""

    def loose_answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the answer even where no question asks for it, as for an extreme at an end of an interval.

        By default `answer`.
        """
        return self.answer(query, study)

    def with_likely_answer(self, query: Query, answer: float) -> Query:
        """Return a query that contains a likely answer, to speed up the search; 0 stands for an unknown one.

        By default as it is.
        """
        del answer
        return query

    def far_answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the answer in a scene misread by a solver, searched for in a wide range; by default `loose_answer`."""
        return self.loose_answer(query, study)

    @abstractmethod
    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return all sentences of a query, the most usual first; `noun` is the phrase for its target, if any."""

    def former_sentences(self, query: Query, words: Words) -> tuple[str, ...]:
        """Return sentences of earlier versions, which are parsed but no longer written; by default none."""
        del query, words
        return ()

    def noun_phrases(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return noun phrases for the answer, including its moment: *the speed of A when B first stops*.

        They are for questions that state it as a condition; by default there are none, and it is never stated.
        """
        del query, words, noun
        return ()

    def statements(self, query: Query, words: Words, noun: Noun | None, value: str) -> tuple[str, ...]:
        """Return statements that the answer has a value, given with its unit; the first one can stand in a clause."""
        return tuple(f"{called} is {value}" for called in self.noun_phrases(query, words, noun))

    def condition_phrases(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return noun phrases for the answer that fit a condition, *X shall be 2 m/s*; by default `noun_phrases`."""
        return self.noun_phrases(query, words, noun)

    @abstractmethod
    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield all queries that a sentence may express; `targets` are the targets that the sentence names.

        The query whose `shapes` contain the sentence, word for word, is the correct one.
        """

    def finds(self, words: Words) -> tuple[str, ...]:
        """Return the names of everything that a structured question of this kind can find; by default none."""
        del words
        return ()

    def posed(self, asked: StructuredQuestion, study: SimulatedScene, words: Words) -> Query | None:
        """Return the query for a structured question about something that this kind can find; None for any other.

        By default None. TextError for a part that has no meaning.
        """
        del asked, study, words

    def late_answer(self, query: Query) -> float | None:
        """Return the limit of the answer for ever later moments: inf for times; by default None for other answers."""
        return inf if self.measured(query).name == "time" else None

    def time(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the time, s, by which the answer is determined; None if it never is. By default that of the moment."""
        return study.time(query.moment) if query.moment is not None else None

    def channels(self, query: Query) -> tuple[Channel, ...]:
        """Return the channels that must be certified for the answer; by default that of the target."""
        return (Channel(query.target.subject, query.target.quantity),) if query.target is not None else ()

    def doubt(self, query: Query, study: SimulatedScene, certificate: Certificate | None) -> str:
        """Return a short reason why the answer is not certified; empty if it is.

        By default its channels must be certified from the start to its time. The certificate is None if there is no
        second engine.
        """
        return certification_gap(certificate, self.time(query, study), query.moment, self.channels(query))

    def indifferent(self, query: Query, study: SimulatedScene, other: SimulatedScene) -> bool:
        """Return whether another scene differs only in numbers that cannot affect the answer; by default False."""
        del query, study, other
        return False

    def measured(self, query: Query) -> Measured:
        """Return the quantity, unit and smallest value of the answer; by default those of the target."""
        assert query.target is not None, "a kind that asks for no quantity says what it asks for"
        quantity = QUANTITIES[query.target.quantity]
        return Measured(quantity.name, quantity.unit, quantity.least)


class ValueKind(Kind):
    """The base class of kinds that ask for a quantity at a moment; each moment declares its kind.

    Class data:
        timeless: whether the kind asks for constant quantities, without a moment.
    """

    timeless: ClassVar[bool] = False

    def moments(self) -> list[type[Moment]]:
        """Return the classes of moments of this kind; UnknownNameError if a moment declares an unknown kind."""
        return [moment for moment in moments_by_cause() if KINDS[moment.kind] is self]

    def answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the quantity in SI units at the moment, or just before if the words say so; None without one."""
        assert query.target is not None
        assert query.moment is not None
        time = study.time(query.moment)
        return None if time is None else query.target.value(study.trace.at(query.moment.evaluation_time(time)))

    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return the forms of the question, such as *what is the speed of A 0.80 s after release?*."""
        assert noun is not None
        return asking_then(query, words, noun)

    def noun_phrases(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return noun phrases for the answer, such as *the speed of A when B first stops*."""
        assert noun is not None
        return naming_then(query, words, noun)

    def statements(self, query: Query, words: Words, noun: Noun | None, value: str) -> tuple[str, ...]:
        """Return statements of the result, such as *when B first stops, A is moving at 2.1 m/s*."""
        assert noun is not None
        return stating_then(query, words, noun, value)

    def finds(self, words: Words) -> tuple[str, ...]:
        """Return the names of all quantities in the scene."""
        return tuple(quantities_named(words.mechanism))

    def posed(self, asked: StructuredQuestion, study: SimulatedScene, words: Words) -> Query | None:
        """Return the query for a quantity at a moment of this kind; None at other moments."""
        del study
        moment = moment_of(asked, words) if asked.when != EQUILIBRIUM else None
        asks = moment and KINDS[moment.kind] is self
        return Query(self.name, target_named(asked, words), moment) if asks else None

    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield a query for every quantity and every moment that a sentence names."""
        named = [target for target, noun in targets.items() if self.timeless or not noun.timeless]
        for cls in self.moments():
            for moment in cls.parsed(text, study.trace, words):
                yield from (Query(self.name, target, moment) for target in named)


K = TypeVar("K", bound=Kind)
M = TypeVar("M", bound=Moment)


def check_share(name: str, member: object) -> None:
    """Raise ValueError if a kind declares no positive share, so that it would never be drawn."""
    share = getattr(member, "share", 0.0)
    if not (share > 0.0 and isfinite(share)):
        raise ValueError(f"questions.kinds: {name!r} has the share {share}, so it would never be asked; declare one")
    if getattr(member, "name", "") != name:
        raise ValueError(f"questions.kinds: {name!r} calls itself {getattr(member, 'name', '')!r}; use one name")


KINDS: Registry[Kind] = Registry("questions.kinds", check_share)


def kind(cls: type[K]) -> type[K]:
    """Register a kind of question under its name."""
    KINDS.add(cls.name, cls())
    return cls


def kinds_by_share(rng: np.random.Generator) -> list[Kind]:
    """Return all kinds with numeric answers in random order, weighted by share, for use until a motion offers one."""
    kinds = [kind for kind in KINDS.values() if not kind.names_one]
    shares = np.array([kind.share for kind in kinds])
    order = rng.choice(len(kinds), size=len(kinds), replace=False, p=shares / shares.sum())
    return [kinds[number] for number in order.tolist()]


def moments_by_cause() -> list[type[Moment]]:
    """Return all classes of moments: first those that the motion determines, then those with a drawn number."""
    return sorted(MOMENTS.values(), key=lambda moment: not moment.event)


def draw_moment(
    classes: list[type[M]],
    study: SimulatedScene,
    words: Words,
    rng: np.random.Generator,
    wanted: Callable[[M], bool] = lambda _: True,
) -> M | None:
    """Return a random moment of a motion, of a random class, that satisfies a predicate; None if there is none.

    The moment is late enough for everything in the text to affect it.
    """
    classes = [cls for cls in classes if cls.drawn_by_recipes]
    order: list[int] = rng.permutation(len(classes)).tolist()
    for number in order:
        offered = classes[number].found(study, words, rng)
        moments = [moment for moment in offered if wanted(moment) and _bears(study, moment)]
        if moments:
            return moments[int(rng.integers(len(moments)))]
    return None


def _bears(study: SimulatedScene, moment: Moment) -> bool:
    time = study.time(moment)
    if time is None or not has_collided(study.trace, time, just_after=bool(moment.sided)):
        return False
    return time >= data_relevant_from(study.trace) * (1.0 - EVENT_TIME_RTOL)
