"""What kinds of question share that ask how the answer to another question depends on one number of the scene."""

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
from sim2reason.questions.study import BEYOND, SHORTEST, Study
from sim2reason.questions.words import Words
from sim2reason.simulation.certify import witnessed
from sim2reason.simulation.channels import Channel
from sim2reason.simulation.quantities import QUANTITIES

INNER = ("start", "state", "event", "time_to_event", "period", "sum", "extremum")
"""The kinds whose answers are compared."""
SAMPLES = 41  # of a motion that the second engine is asked about
DRAWS = 2  # of questions of such kinds
AWKWARD = "the magnitude of the change"  # of which no change is asked for
NUMBERS = 3  # that are tried with each


@dataclass(frozen=True, slots=True)
class NestedQuery(Query):
    """A query about the answer to another one, as a function of the number at an address of the scene.

    The target and the moment are those of the other query; `base` is the rest of it.
    """

    base: Query | None = None
    path: str = ""

    @property
    def inner(self) -> Query:
        """The other query."""
        assert self.base is not None
        return replace(self.base, target=self.target, moment=self.moment)

    def others(self, study: Study) -> list[Study | None]:
        """Return the motions with other values of the number, to compare with a given motion; by default none."""
        del study
        return []

    @property
    def subject(self) -> str:
        """That of the other query."""
        return self.inner.subject


class NestedKind(Kind):
    """A question about how the answer to another question depends on a number of the scene.

    Class data:
        inner: the kinds of the other question.
    """

    derivable = True
    costly = True
    inner: ClassVar[tuple[str, ...]] = INNER

    def draw(self, study: Study, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a question of another kind and a number, if they are worth it."""
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

    def _numbers(self, study: Study, words: Words, rng: np.random.Generator) -> Iterable[str]:
        """The addresses of the numbers that may change, in a random order; by default of all that can be named."""
        del study
        paths = list(words.named)
        order: list[int] = rng.permutation(len(paths)).tolist()
        return [paths[number] for number in order]

    def _is_named(self, inner: Query, words: Words, targets: Targets) -> bool:
        """Return whether the answer to another question has a name about which this may be asked."""
        noun = targets.get(inner.target) if inner.target is not None else None
        names = KINDS[inner.kind].called(inner, words, noun) if noun is not None or inner.target is None else ()
        return bool(names) and self._can_be_about(names[0])

    def _can_be_about(self, name: str) -> bool:
        """Return whether one would ask this of what has a name; by default not of how much something changes."""
        return not name.startswith(AWKWARD)

    @abstractmethod
    def _worth(self, inner: Query, path: str, study: Study, rng: np.random.Generator) -> Query | None:
        """Return a query about another query and a number, or None if it is not worth asking."""

    def of_motion(self, query: Query) -> bool:
        """As the other question has it."""
        inner = inner_of(query)
        return KINDS[inner.kind].of_motion(inner)

    def channels(self, query: Query) -> tuple[Channel, ...]:
        """Return those of the other question."""
        inner = inner_of(query)
        return KINDS[inner.kind].channels(inner)

    def indifferent(self, query: Query, study: Study, other: Study) -> bool:
        """To what the other question is indifferent to."""
        inner = inner_of(query)
        return KINDS[inner.kind].indifferent(inner, study, other)

    def names(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return the noun phrases for the answer to the other question."""
        inner = inner_of(query)
        return KINDS[inner.kind].called(inner, words, noun)

    def inner_parsed(self, text: str, study: Study, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield all other questions that a sentence could speak of."""
        for name in self.inner:
            yield from filter(is_plain, KINDS[name].parsed(text, study, words, targets))


def inner_of(query: Query) -> Query:
    """Return the other query that a query is about."""
    assert isinstance(query, NestedQuery)
    return query.inner


def stripped(inner: Query) -> Query:
    """Return a query without its target and moment, which the query about it has itself."""
    return replace(inner, target=None, moment=None)


def answered(inner: Query, study: Study | None, *, loosely: bool = False) -> float | None:
    """Return the answer to a query in a motion as far as that may be used; None without a motion or an answer."""
    if study is None or not _has_subject(inner, study):
        return None
    kind = KINDS[inner.kind]
    time = kind.time(inner, study)
    if time is None or time > study.trace.stable_until:
        return None
    found = kind.loose_answer(inner, study) if loosely else kind.answer(inner, study)
    return found if found is not None and np.isfinite(found) else None


def vouched(inner: Query, other: Study) -> str:
    """Why both engines don't vouch for the answer to a query in a motion that is followed afresh; empty if they do."""
    kind, least = KINDS[inner.kind], SHORTEST * other.scene.horizon
    until = max(BEYOND * (kind.time(inner, other) or 0.0), least)
    seen, certificate = witnessed(Study.of(other.scene, np.linspace(0.0, until, SAMPLES)).trace)
    return kind.doubt(inner, Study(other.scene, seen), certificate)


def _has_subject(inner: Query, study: Study) -> bool:
    """Return whether a changed mechanism still has what is asked about."""
    target = inner.target
    return target is None or target.subject in QUANTITIES[target.quantity].subjects(study.mechanism)


def _is_natural(inner: Query) -> bool:
    """Return whether a query is worth comparing: it is plain, and its moment is an event, not an arbitrary instant."""
    return is_plain(inner) and not isinstance(inner.moment, AtTime)


def is_plain(inner: Query) -> bool:
    """Return whether it asks for a size of a quantity that has a value as a number."""
    if isinstance(inner, StretchQuery):
        return FUNCTIONALS[inner.functional].kind != "count"
    return inner.target is None or inner.target.sense is None or inner.target.sense.fixed
