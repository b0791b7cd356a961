"""Base classes of questions about another question's answer: its dependence on a number, and two candidates."""

from abc import abstractmethod
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import islice
from math import isfinite
from typing import ClassVar

import numpy as np

from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.kinds import KINDS, Kind
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.query import Noun, Query, Targets
from sim2reason.questions.study import MIN_VARIANT_FRACTION, TIME_MARGIN, SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.simulation.certify import Certificate, certify_trace
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import Channel

INNER = ("start", "state", "event", "time_to_event", "period", "sum", "extremum")
"""The kinds whose answers are compared."""
WITNESS_SAMPLES = 41  # instants of a motion that the second engine simulates
MAX_INNER_DRAWS = 2  # drawn inner questions
AWKWARD = "the magnitude of the change"  # the prefix of a noun phrase of which no change is asked for
MAX_NUMBERS = 3  # numbers tried with each inner question


@dataclass(frozen=True, slots=True)
class NestedQuery(Query):
    """A query about another query's answer as a function of the number at an address of the scene.

    The target and the moment are those of the other query; `base` is the rest of it.
    """

    base: Query | None = None
    path: str = ""

    @property
    def inner(self) -> Query:
        """Return the inner query."""
        assert self.base is not None
        return replace(self.base, target=self.target, moment=self.moment)

    def others(self, study: SimulatedScene) -> list[SimulatedScene | None]:
        """Return the motions with other values of the number, to compare with a given motion; by default none."""
        del study
        return []

    @property
    def subject(self) -> str:
        """Return the subject of the inner query."""
        return self.inner.subject


class NestedKind(Kind):
    """The base class of kinds that ask how another question's answer depends on a number of the scene.

    Class data:
        inner: the kinds of the other question.
    """

    derivable = True
    costly = True
    inner: ClassVar[tuple[str, ...]] = INNER

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a random query about an inner question and a number that is worth asking; None if there is none."""
        if study.mechanism is not study.scene.mechanism:
            return None
        shares = np.array([KINDS[name].share for name in self.inner])
        kinds: list[int] = rng.choice(len(shares), len(shares), replace=False, p=shares / shares.sum()).tolist()
        drawn = (KINDS[self.inner[number]].draw(study, words, targets, rng) for number in kinds)
        for inner in islice((query for query in drawn if query is not None and _is_natural(query)), MAX_INNER_DRAWS):
            if not self._is_named(inner, words, targets):
                continue
            for path in islice(self._draw_number_paths(study, words, rng), MAX_NUMBERS):
                query = self._compose_query(inner, path, study, rng)
                if query is not None:
                    return query
        return None

    def _draw_number_paths(self, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Iterable[str]:
        """Return the addresses of numbers that may vary, in random order; by default all that have names."""
        del study
        paths = list(words.named)
        order: list[int] = rng.permutation(len(paths)).tolist()
        return [paths[number] for number in order]

    def _is_named(self, inner: Query, words: Words, targets: Targets) -> bool:
        """Return whether the inner answer has a noun phrase that this kind can use."""
        noun = targets.get(inner.target) if inner.target is not None else None
        names = KINDS[inner.kind].noun_phrases(inner, words, noun) if noun is not None or inner.target is None else ()
        return bool(names) and self._can_be_about(names[0])

    def _can_be_about(self, name: str) -> bool:
        """Return whether this kind may ask about a noun phrase; by default not about a change."""
        return not name.startswith(AWKWARD)

    @abstractmethod
    def _compose_query(self, inner: Query, path: str, study: SimulatedScene, rng: np.random.Generator) -> Query | None:
        """Return a query about an inner query and a number; None if it is not worth asking."""

    def of_motion(self, query: Query) -> bool:
        """Return whether the inner answer may depend on the initial motion."""
        inner = inner_of(query)
        return KINDS[inner.kind].of_motion(inner)

    def channels(self, query: Query) -> tuple[Channel, ...]:
        """Return the channels of the inner query."""
        inner = inner_of(query)
        return KINDS[inner.kind].channels(inner)

    def indifferent(self, query: Query, study: SimulatedScene, other: SimulatedScene) -> bool:
        """Return whether the inner answer is unaffected by the differences between the scenes."""
        inner = inner_of(query)
        return KINDS[inner.kind].indifferent(inner, study, other)

    def names(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return the noun phrases for the inner answer."""
        inner = inner_of(query)
        return KINDS[inner.kind].noun_phrases(inner, words, noun)

    def inner_parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield all inner queries that a sentence may contain."""
        for name in self.inner:
            yield from filter(is_plain, KINDS[name].parsed(text, study, words, targets))


def inner_of(query: Query) -> Query:
    """Return the inner query of a nested query."""
    assert isinstance(query, NestedQuery)
    return query.inner


def without_target_and_moment(inner: Query) -> Query:
    """Return a query without its target and moment, which the nested query has itself."""
    return replace(inner, target=None, moment=None)


def usable_answer(inner: Query, study: SimulatedScene | None, *, loosely: bool = False) -> float | None:
    """Return the answer to a query in a motion, if it is finite and known before the simulation ends; else None."""
    if study is None or not _has_subject(inner, study):
        return None
    kind = KINDS[inner.kind]
    time = kind.time(inner, study)
    if time is None or time > study.trace.stable_until:
        return None
    answer = kind.loose_answer(inner, study) if loosely else kind.answer(inner, study)
    return answer if answer is not None and np.isfinite(answer) else None


def variant_certification_gap(inner: Query, other: SimulatedScene) -> str:
    """Return why the answer to a query in a newly simulated motion is not certified; empty if it is."""
    kind, shortest = KINDS[inner.kind], MIN_VARIANT_FRACTION * other.scene.horizon
    until = max(TIME_MARGIN * (kind.time(inner, other) or 0.0), shortest)
    seen, certificate = certify_trace(SimulatedScene.of(other.scene, np.linspace(0.0, until, WITNESS_SAMPLES)).trace)
    return kind.doubt(inner, SimulatedScene(other.scene, seen), certificate)


def _has_subject(inner: Query, study: SimulatedScene) -> bool:
    """Return whether a changed mechanism still has the query's subject."""
    target = inner.target
    return target is None or target.subject in QUANTITIES[target.quantity].subjects(study.mechanism)


def _is_natural(inner: Query) -> bool:
    """Return whether a query suits a comparison: it asks for no count, and not at an arbitrary stated time."""
    return is_plain(inner) and not isinstance(inner.moment, AtTime)


def is_plain(inner: Query) -> bool:
    """Return whether a query asks neither for a count nor for a component along a variable direction."""
    if isinstance(inner, StretchQuery):
        return FUNCTIONALS[inner.functional].kind != "count"
    return inner.target is None or inner.target.sense is None or inner.target.sense.fixed


OR = " or "
"""Separator of the two subjects or moments in a structured question for one of them."""
MIN_RELATIVE_DIFFERENCE = 0.1  # relative: least difference between the two values


@dataclass(frozen=True, slots=True)
class WhichQuery(Query):
    """A pair of queries, one of which the answer names: the first query, in the motion for which the pair was drawn.

    The target and the moment are those of the first query, `base` is the kind of both, and `other` is the second one.
    """

    base: str = ""
    other: Query | None = None

    @property
    def both(self) -> tuple[Query, Query]:
        """Return the two queries, the correct one first."""
        assert self.other is not None
        return Query(self.base, self.target, self.moment), self.other

    @property
    def exchanged(self) -> "WhichQuery":
        """Return the pair of queries in reverse order."""
        first, second = self.both
        return replace(self, target=second.target, moment=second.moment, other=first)

    @property
    def subjects(self) -> tuple[str, ...]:
        """Return the names of all subjects of both queries."""
        moments = (query.moment for query in self.both)
        named = (name for moment in moments if moment is not None for name in moment.subjects)
        return tuple(dict.fromkeys((*(query.subject for query in self.both), *named)))


class WhichKind(Kind):
    """The base class of kinds whose answer names one of two candidates and a number.

    Answers are positive if the first candidate is right, negative if the second is.
    """

    names_one = True
    derivable = True
    costly = True  # one wrong number makes its options: in place of others it would be asked too often
    of_symbols = False
    is_least: ClassVar[bool]
    """Whether the candidate with the smaller value is right, or the one with the greater."""

    @abstractmethod
    def number(self, less: float, greater: float) -> float | None:
        """Return the number asked for, from the two values in ascending order; None if it does not exist."""

    @abstractmethod
    def names(self, query: WhichQuery, words: Words) -> tuple[str, str] | None:
        """Return the names of both candidates for options; None if they are not distinct."""

    @abstractmethod
    def option(self, query: WhichQuery, words: Words, number: str, *, first: bool) -> str:
        """Return the text of an option that names the first or the second candidate, and a `number` with its unit."""

    @abstractmethod
    def conclusion(self, query: WhichQuery, words: Words) -> str:
        """Return the clause that concludes a solution in which the first candidate is right, up to the number."""

    def answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the number, negative if the second candidate is right."""
        return self._answer(query, study, loosely=False)

    def loose_answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the number asked for, computed also from two answers that no question asks for."""
        return self._answer(query, study, loosely=True)

    def _answer(self, query: Query, study: SimulatedScene, *, loosely: bool) -> float | None:
        first, second = (usable_answer(each, study, loosely=loosely) for each in _pair_of(query))
        if first is None or second is None:
            return None
        answer = self.number(min(first, second), max(first, second))
        return answer if answer is None or (first <= second if self.is_least else first >= second) else -answer

    def oriented(self, query: WhichQuery, study: SimulatedScene) -> WhichQuery:
        """Return the query with the candidate first that is correct in a motion; unchanged if there is no answer."""
        answer = self.answer(query, study)
        return query.exchanged if answer is not None and answer < 0.0 else query

    def worth(self, query: WhichQuery, study: SimulatedScene, words: Words) -> WhichQuery | None:
        """Return the oriented query; None if the values hardly differ or the text cannot tell the candidates apart."""
        first, second = (usable_answer(each, study) for each in query.both)
        if (
            first is None
            or second is None
            or not abs(first - second) > MIN_RELATIVE_DIFFERENCE * max(abs(first), abs(second))
        ):
            return None
        answer = self.answer(query, study)
        if answer is None or not isfinite(answer) or self.names(query, words) is None:
            return None
        return self.oriented(query, study)

    def of_motion(self, query: Query) -> bool:
        """Return whether either answer may depend on the initial motion."""
        return any(KINDS[each.kind].of_motion(each) for each in _pair_of(query))

    def time(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the time, s, by which both answers are determined; None if one never is."""
        times = [KINDS[each.kind].time(each, study) if _is_possible(each, study) else None for each in _pair_of(query)]
        known = [time for time in times if time is not None]
        return max(known) if len(known) == len(times) else None

    def channels(self, query: Query) -> tuple[Channel, ...]:
        """Return the channels of both queries."""
        return tuple(channel for each in _pair_of(query) for channel in KINDS[each.kind].channels(each))

    def doubt(self, query: Query, study: SimulatedScene, certificate: Certificate | None) -> str:
        """Return the first reason why either query is not certified; empty if both are."""
        reasons = (KINDS[each.kind].doubt(each, study, certificate) for each in _pair_of(query))
        return next(filter(None, reasons), "")

    def orders(self, query: WhichQuery, words: Words) -> Iterator[tuple[WhichQuery, str, str]]:
        """Yield the two candidates with their names in both orders, since a fixed order would reveal the answer."""
        for ordered in (query, query.exchanged):
            names = self.names(ordered, words)
            if names is not None:
                yield ordered, *names


def _pair_of(query: Query) -> tuple[Query, Query]:
    """Return the two queries of a `WhichQuery`."""
    assert isinstance(query, WhichQuery)
    return query.both


def _is_possible(query: Query, study: SimulatedScene) -> bool:
    return query.moment is None or query.moment.possible(study.mechanism)
