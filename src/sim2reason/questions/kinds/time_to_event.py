"""Questions for the time of an event."""

from collections.abc import Iterator

import numpy as np

from sim2reason.questions.kinds import Kind, Measured, draw_moment, kind, moments_by_cause
from sim2reason.questions.moments import Happening, Moment
from sim2reason.questions.moments.parts.reached import moment_of
from sim2reason.questions.query import Noun, Query, Targets
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words


@kind
class TimeToEventKind(Kind):
    """The kind that asks for the time from the start to the first occurrence of an event."""

    name = "time_to_event"
    share = 0.18

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query for the time of a random event of the motion; None if there is none."""
        del targets

        def wanted(moment: Happening) -> bool:
            return moment.clause(words) is not None and not moment.is_plain(study)

        moment = draw_moment(_happenings(), study, words, rng, wanted)
        return Query(self.name, None, moment) if moment is not None else None

    def at(
        self, moment: Moment, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Return the query for the time of the given moment; None if the time is not worth asking for."""
        del targets, rng
        asked = isinstance(moment, Happening) and moment.clause(words) is not None and not moment.is_plain(study)
        return Query(self.name, None, moment) if asked else None

    def answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the time of the event, s; None if it does not occur."""
        return self.time(query, study)

    def measured(self, query: Query) -> Measured:
        """Return the unit of a time, s, and the least answer, 0.01 s."""
        del query
        return Measured("time", "s", least=1e-2)

    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return sentences such as *how long after release is B first 0.50 m from its starting point?*."""
        del noun
        assert isinstance(query.moment, Happening)
        clause, since = query.moment.clause(words), words.since
        if clause is None:
            return ()
        takes = f"how long does {clause.subject} take {clause.takes}, counted from {since}?"
        return (
            takes if clause.takes else f"how long after {since} {clause.question}?",
            f"how much time passes from {since} until {clause.statement}?",
            f"find the time from {since} until {clause.statement}.",
            f"what is the time from {since} until {clause.statement}?",
            f"determine how long after {since} {clause.statement}.",
        )

    def noun_phrases(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return noun phrases for the answer, such as *the time from release until B first stops*."""
        del noun
        assert isinstance(query.moment, Happening)
        clause = query.moment.clause(words)
        return (f"the time from {words.since} until {clause.statement}",) if clause is not None else ()

    def statements(self, query: Query, words: Words, noun: Noun | None, value: str) -> tuple[str, ...]:
        """Return statements of the result, such as *B first stops 1.2 s after release*."""
        assert isinstance(query.moment, Happening)
        clause, since = query.moment.clause(words), words.since
        if clause is None:
            return ()
        takes = f"{clause.subject} takes {value} {clause.takes}, counted from {since}"
        natural = takes if clause.takes else f"{clause.statement} {value} after {since}"
        return (natural, *super().statements(query, words, noun, value))

    def condition_phrases(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return no noun phrases if `statements` has a sentence, which reads better than *the time until …*."""
        return () if self.statements(query, words, noun, "") else self.noun_phrases(query, words, noun)

    def finds(self, words: Words) -> tuple[str, ...]:
        """Return the name *time*."""
        del words
        return ("time",)

    def posed(self, asked: StructuredQuestion, study: SimulatedScene, words: Words) -> Query | None:
        """Return the query for the time of a moment, or of a quantity's first reaching a stated value."""
        del study
        return Query(self.name, None, moment_of(asked, words))

    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield a query for every event that a sentence names."""
        del targets
        for cls in _happenings():
            yield from (Query(self.name, None, moment) for moment in cls.parsed(text, study.trace, words))


def _happenings() -> list[type[Happening]]:
    return [cls for cls in moments_by_cause() if issubclass(cls, Happening)]
