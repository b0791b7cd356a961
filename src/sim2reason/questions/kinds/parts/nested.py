"""Base classes of questions about the dependence of another question's answer on one number of the scene."""

from abc import abstractmethod
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import islice
from typing import ClassVar

import numpy as np

from sim2reason.questions.functionals import FUNCTIONALS
from sim2reason.questions.kinds import KINDS, Kind
from sim2reason.questions.kinds.parts.stretch_kind import StretchQuery
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.query import Noun, Query, Targets
from sim2reason.questions.study import SHORTEST, TIME_MARGIN, SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.simulation.certify import certify_trace
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.quantities import QUANTITIES

INNER = ("start", "state", "event", "time_to_event", "period", "sum", "extremum")
"""The kinds whose answers are compared."""
SAMPLES = 41  # instants of a motion that the second engine simulates
DRAWS = 2  # drawn inner questions
AWKWARD = "the magnitude of the change"  # the prefix of a noun phrase of which no change is asked for
NUMBERS = 3  # numbers tried with each inner question


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
        for inner in islice((query for query in drawn if query is not None and _is_natural(query)), DRAWS):
            if not self._is_named(inner, words, targets):
                continue
            for path in islice(self._numbers(study, words, rng), NUMBERS):
                query = self._worth(inner, path, study, rng)
                if query is not None:
                    return query
        return None

    def _numbers(self, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Iterable[str]:
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
    def _worth(self, inner: Query, path: str, study: SimulatedScene, rng: np.random.Generator) -> Query | None:
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


def stripped(inner: Query) -> Query:
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
    found = kind.loose_answer(inner, study) if loosely else kind.answer(inner, study)
    return found if found is not None and np.isfinite(found) else None


def variant_certification_gap(inner: Query, other: SimulatedScene) -> str:
    """Return why the answer to a query in a newly simulated motion is not certified; empty if it is."""
    kind, least = KINDS[inner.kind], SHORTEST * other.scene.horizon
    until = max(TIME_MARGIN * (kind.time(inner, other) or 0.0), least)
    seen, certificate = certify_trace(SimulatedScene.of(other.scene, np.linspace(0.0, until, SAMPLES)).trace)
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
