"""Questions for the earlier of two events, and the time between them."""

from collections.abc import Iterator, Sequence
from itertools import combinations

import numpy as np

from sim2reason.questions.kinds import Measured, draw_moment, kind, moments_by_cause
from sim2reason.questions.kinds.nested import OR, WhichKind, WhichQuery
from sim2reason.questions.moments import Clause, Happening, Moment
from sim2reason.questions.moments.reached import moment_of
from sim2reason.questions.query import Noun, Query, Targets
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words

TIME_KIND = "time_to_event"
FIRST, AGAIN = "first ", " for the first time"
MAX_PAIRS = 4  # pairs examined in one draw
SPEED_RATIO_RTOL = 1e-6  # relative: a smaller difference of speed ratios is rounding
MAX_OTHER_EVENTS = 3  # further events examined in one draw


@kind
class WhichFirstKind(WhichKind):
    """The kind that asks which of two events comes first, and how much earlier."""

    name = "which_first"
    share = 0.12
    is_least = True

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query for two events of the motion, or for one event of two subjects; None without such a pair."""
        del targets

        def wanted(moment: Happening) -> bool:
            return _clause(moment, words) is not None and not moment.is_plain(study)

        moment = draw_moment(_event_classes(), study, words, rng, wanted)
        if moment is None:
            return None
        offered = [other for other in type(moment).found(study, words, rng) if wanted(other)]
        same = [other.having([value for value, _ in moment.stated]) for other in offered]
        draws = (
            0 if moment.stated or _moves_as_one(study) else MAX_OTHER_EVENTS
        )  # else what happens first is a matter of places
        further = (draw_moment(_event_classes(), study, words, rng, wanted) for _ in range(draws))
        others = [*_shuffled(same, rng)[:MAX_PAIRS], *(other for other in further if other and not other.stated)]
        for other in others:
            if set(moment.subjects).isdisjoint(other.subjects) and study.time(other) is not None:
                query = self.worth(_query(moment, other), study, words)
                if query is not None:
                    return query
        return None

    def number(self, less: float, greater: float) -> float:
        """Return the time between the two events, s."""
        return greater - less

    def measured(self, query: Query) -> Measured:
        """Return the quantity, unit and least value of the answer: a time difference, in s, of at least 0.01 s."""
        del query
        return Measured("difference", "s", least=1e-2)

    def names(self, query: WhichQuery, words: Words) -> tuple[str, str] | None:
        """Return the names of both subjects if the two events are of one kind, else the clauses of both events."""
        first, second = (_clause(each.moment, words) for each in query.both)
        if first is None or second is None or first.subject == second.subject:
            return None
        if _deed(first) and _deed(first) == _deed(second):
            return first.subject, second.subject
        return _statement(first), _statement(second)

    def option(self, query: WhichQuery, words: Words, number: str, *, first: bool) -> str:
        """Return an option such as *block A, 0.41 s before block B*."""
        names, same = self.names(query, words), self._deed_of(query, words)
        assert names is not None
        name, other = names if first else names[::-1]
        return f"{name}, {number} before {other}" if same else f"{name} first, {number} earlier"

    def conclusion(self, query: WhichQuery, words: Words) -> str:
        """Return a clause such as *block A is the first to come to rest, earlier than block B by*."""
        first, second = self.names(query, words) or ("it", "the other")
        deed = self._deed_of(query, words)
        return f"{first} is the first to {deed}, earlier than {second} by" if deed else f"{first} first, earlier by"

    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return the forms of the question: *which of A and B is the first to come to rest, and how much earlier?*."""
        del noun
        assert isinstance(query, WhichQuery)
        deed = self._deed_of(query, words)
        orders = self.orders(query, words)
        shapes = (shape for _, a, b in orders for shape in (_same(a, b, deed) if deed else _two(a, b)))
        return tuple(dict.fromkeys(shapes))

    def finds(self, words: Words) -> tuple[str, ...]:
        """Return the name *time*."""
        del words
        return ("time",)

    def posed(self, asked: StructuredQuestion, study: SimulatedScene, words: Words) -> Query | None:
        """Return the query for two moments, as in *block A stopped or block B stopped*; None without the *or*."""
        first, separator, second = asked.when.partition(OR)
        if not separator:
            return None
        moments = (moment_of(StructuredQuestion("time", when=when), words) for when in (first, second))
        return self.oriented(_query(*moments), study)

    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield a query for each two events that a text names."""
        del targets
        if not text.lower().startswith(("which ", "find which ", "determine which ")):
            return
        moments = [moment for cls in _event_classes() for moment in cls.parsed(text, study.trace, words)]
        named = [moment for moment in dict.fromkeys(moments) if _is_named(moment, text, words)]
        yield from (self.oriented(_query(*pair), study) for pair in combinations(named, 2))

    def _deed_of(self, query: WhichQuery, words: Words) -> str:
        """Return the infinitive for the action of both subjects; empty if their actions differ."""
        deeds = {_deed(clause) for each in query.both if (clause := _clause(each.moment, words)) is not None}
        return deeds.pop() if len(deeds) == 1 else ""


def _moves_as_one(study: SimulatedScene) -> bool:
    """Return whether all speeds keep constant ratios, as in a motion with one degree of freedom."""
    return study.memoize(
        "moves as one", lambda: int(np.linalg.matrix_rank(study.trace.scan.v, rtol=SPEED_RATIO_RTOL)) < 2
    )


def _query(first: Moment, second: Moment) -> WhichQuery:
    return WhichQuery(WhichFirstKind.name, None, first, TIME_KIND, Query(TIME_KIND, None, second))


def _event_classes() -> list[type[Happening]]:
    return [cls for cls in moments_by_cause() if issubclass(cls, Happening)]


def _shuffled(moments: Sequence[Happening], rng: np.random.Generator) -> list[Happening]:
    order: list[int] = rng.permutation(len(moments)).tolist()
    return [moments[number] for number in order]


def _clause(moment: Moment | None, words: Words) -> Clause | None:
    return moment.clause(words) if isinstance(moment, Happening) else None


def _deed(clause: Clause) -> str:
    """Return the infinitive of an event without *to*: *come to rest*, *move 0.50 m*; empty if it has none."""
    if clause.takes:
        return clause.takes.removeprefix("to ").removesuffix(AGAIN)
    return {"does": "", "do": "", "is": "be "}.get(clause.auxiliary, "has ") + clause.asked.replace(FIRST, "", 1)


def _statement(clause: Clause) -> str:
    """Return the clause of an event: *block A comes to rest*."""
    return f"{clause.subject} {clause.told.replace(FIRST, '', 1).removesuffix(AGAIN)}"


def _is_named(moment: Happening, text: str, words: Words) -> bool:
    clause = _clause(moment, words)
    if clause is None or clause.subject not in text:
        return False
    return _deed(clause) in text or _statement(clause) in text


def _same(first: str, second: str, deed: str) -> tuple[str, ...]:
    """Return the forms of a question for two subjects of the same event."""
    return (
        f"which of {first} and {second} is the first to {deed}, and how much earlier than the other?",
        f"which is the first to {deed}, {first} or {second}, and how much earlier than the other?",
        f"determine which of {first} and {second} is the first to {deed}, and how much earlier than the other.",
    )


def _two(first: str, second: str) -> tuple[str, ...]:
    """Return the forms of a question for two different events."""
    return (
        f"which happens first, and how much earlier: {first} or {second}?",
        f"which of these happens first, and how much earlier than the other: {first} or {second}?",
        f"determine which happens first, and how much earlier: {first} or {second}.",
    )
