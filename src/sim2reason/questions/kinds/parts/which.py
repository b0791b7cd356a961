"""Base classes of questions that compare two candidates and ask for a difference or a ratio."""

from abc import abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import isfinite
from typing import ClassVar

from sim2reason.questions.kinds import KINDS, Kind
from sim2reason.questions.kinds.parts.nested import usable_answer
from sim2reason.questions.query import Query
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.simulation.certify import Certificate
from sim2reason.simulation.channels import Channel

OR = " or "
"""Separator of the two subjects or moments in a structured question for one of them."""
CLEARLY = 0.1  # relative: least difference between the two values


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
        found = self.number(min(first, second), max(first, second))
        return found if found is None or (first <= second if self.is_least else first >= second) else -found

    def oriented(self, query: WhichQuery, study: SimulatedScene) -> WhichQuery:
        """Return the query with the candidate first that is correct in a motion; unchanged if there is no answer."""
        found = self.answer(query, study)
        return query.exchanged if found is not None and found < 0.0 else query

    def worth(self, query: WhichQuery, study: SimulatedScene, words: Words) -> WhichQuery | None:
        """Return the oriented query; None if the values hardly differ or the text cannot tell the candidates apart."""
        first, second = (usable_answer(each, study) for each in query.both)
        if first is None or second is None or not abs(first - second) > CLEARLY * max(abs(first), abs(second)):
            return None
        found = self.answer(query, study)
        if found is None or not isfinite(found) or self.names(query, words) is None:
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
        for held in (query, query.exchanged):
            names = self.names(held, words)
            if names is not None:
                yield held, *names


def _pair_of(query: Query) -> tuple[Query, Query]:
    """Return the two queries of a `WhichQuery`."""
    assert isinstance(query, WhichQuery)
    return query.both


def _is_possible(query: Query, study: SimulatedScene) -> bool:
    return query.moment is None or query.moment.possible(study.mechanism)
