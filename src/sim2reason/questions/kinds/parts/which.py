"""What kinds of question share that ask which of two it is, and for a number beside the name."""

from abc import abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import isfinite
from typing import ClassVar

from sim2reason.questions.kinds import KINDS, Kind
from sim2reason.questions.kinds.parts.nested import answered
from sim2reason.questions.query import Query
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.simulation.certify import Certificate
from sim2reason.simulation.channels import Channel

OR = " or "
"""Between two subjects, or two moments, of a structured question that asks which of them it is."""
CLEARLY = 0.1  # relative: by how much both must differ


@dataclass(frozen=True, slots=True)
class WhichQuery(Query):
    """Which of two queries has the answer that is looked for; in the motion that it was asked about, it is the first.

    The target and the moment are those of the first query, `base` is the kind of both, and `other` is the second one.
    """

    base: str = ""
    other: Query | None = None

    @property
    def both(self) -> tuple[Query, Query]:
        """Both queries, that with the answer first."""
        assert self.other is not None
        return Query(self.base, self.target, self.moment), self.other

    @property
    def exchanged(self) -> "WhichQuery":
        """The same question, with the second query as the first."""
        first, second = self.both
        return replace(self, target=second.target, moment=second.moment, other=first)

    @property
    def subjects(self) -> tuple[str, ...]:
        """What either query is about."""
        moments = (query.moment for query in self.both)
        named = (name for moment in moments if moment is not None for name in moment.subjects)
        return tuple(dict.fromkeys((*(query.subject for query in self.both), *named)))


class WhichKind(Kind):
    """Which of two is it, and what is the number beside the name?

    An answer is positive if it is the first of the two, and negative if it is the second.
    """

    names_one = True
    derivable = True
    costly = True  # one wrong number makes its options: in place of others it would be asked too often
    of_symbols = False
    is_least: ClassVar[bool]
    """Whether that with the less of both answers is looked for, or that with the greater."""

    @abstractmethod
    def number(self, less: float, greater: float) -> float | None:
        """The number that is asked for, of two answers; None where there is none."""

    @abstractmethod
    def names(self, query: WhichQuery, words: Words) -> tuple[str, str] | None:
        """How options call both; None where a text has no words that tell them apart."""

    @abstractmethod
    def option(self, query: WhichQuery, words: Words, number: str, *, first: bool) -> str:
        """What an option says that names the first of both, or the second, and a `number` with its unit."""

    @abstractmethod
    def conclusion(self, query: WhichQuery, words: Words) -> str:
        """The clause with which a solution says that it is the first of the two, to be followed by the number."""

    def answer(self, query: Query, study: Study) -> float | None:
        """The number, negative if the second of the two is the one."""
        return self._answer(query, study, loosely=False)

    def loose_answer(self, query: Query, study: Study) -> float | None:
        """The same of what a reader may answer."""
        return self._answer(query, study, loosely=True)

    def _answer(self, query: Query, study: Study, *, loosely: bool) -> float | None:
        first, second = (answered(each, study, loosely=loosely) for each in pair_of(query))
        if first is None or second is None:
            return None
        found = self.number(min(first, second), max(first, second))
        return found if found is None or (first <= second if self.is_least else first >= second) else -found

    def oriented(self, query: WhichQuery, study: Study) -> WhichQuery:
        """The query with that as the first which is the one in a motion, as far as this is known."""
        found = self.answer(query, study)
        return query.exchanged if found is not None and found < 0.0 else query

    def worth(self, query: WhichQuery, study: Study, words: Words) -> WhichQuery | None:
        """The oriented query, if both clearly differ and can be told apart; else None."""
        first, second = (answered(each, study) for each in query.both)
        if first is None or second is None or not abs(first - second) > CLEARLY * max(abs(first), abs(second)):
            return None
        found = self.answer(query, study)
        if found is None or not isfinite(found) or self.names(query, words) is None:
            return None
        return self.oriented(query, study)

    def of_motion(self, query: Query) -> bool:
        """As either query has it."""
        return any(KINDS[each.kind].of_motion(each) for each in pair_of(query))

    def time(self, query: Query, study: Study) -> float | None:
        """When all has happened that either answer depends on."""
        times = [KINDS[each.kind].time(each, study) if _is_possible(each, study) else None for each in pair_of(query)]
        known = [time for time in times if time is not None]
        return max(known) if len(known) == len(times) else None

    def channels(self, query: Query) -> tuple[Channel, ...]:
        """Those of both."""
        return tuple(channel for each in pair_of(query) for channel in KINDS[each.kind].channels(each))

    def doubt(self, query: Query, study: Study, certificate: Certificate | None) -> str:
        """Both must be vouched for."""
        reasons = (KINDS[each.kind].doubt(each, study, certificate) for each in pair_of(query))
        return next(filter(None, reasons), "")

    def orders(self, query: WhichQuery, words: Words) -> Iterator[tuple[WhichQuery, str, str]]:
        """Both orders in which a text may name the two, the more usual first, so that the order tells nothing."""
        for held in (query, query.exchanged):
            names = self.names(held, words)
            if names is not None:
                yield held, *names


def pair_of(query: Query) -> tuple[Query, Query]:
    """Both queries between which a query asks to decide."""
    assert isinstance(query, WhichQuery)
    return query.both


def _is_possible(query: Query, study: Study) -> bool:
    return query.moment is None or query.moment.possible(study.mechanism)
