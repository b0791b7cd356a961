"""Questions for the greater of two quantities, and their ratio."""

import re
from collections.abc import Iterator
from itertools import combinations, groupby

import numpy as np

from sim2reason.questions.kinds import KINDS, Measured, kind
from sim2reason.questions.kinds.nested import AWKWARD, OR, WhichKind, WhichQuery
from sim2reason.questions.moments.reached import moment_of
from sim2reason.questions.query import Noun, Query, Target, Targets, quantities_named, target_named, targets
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import Channel

DISTANCE = "distance between {} and its starting point"
INNER = ("state", "event", "start")
PROPERTY_PREDICATES = {"speed": "is faster", DISTANCE: "is farther from its starting point"}
"""Comparative phrases for the subject with the greater value of a quantity, where English has one."""
MIN_RATIO = 1.1  # ratio: smaller ones are not worth asking for
MAX_RATIO = 30.0  # ratio: larger ones are not worth asking for
MAGNITUDE = "magnitude of the "


@kind
class WhichGreaterKind(WhichKind):
    """The kind that asks which of two quantities is greater, and by what factor."""

    name = "which_greater"
    share = 0.06
    is_least = False

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query for a quantity of two subjects at one moment; None if there is none."""
        offered = {target: targets[target] for group in _groups_by_quantity(targets) for target in group}
        shares = np.array([KINDS[name].share for name in INNER])
        order: list[int] = rng.choice(len(INNER), len(INNER), replace=False, p=shares / shares.sum()).tolist()
        for name in (INNER[number] for number in order) if offered else ():
            inner = KINDS[name].draw(study, words, offered, rng)
            query = self._with_another(inner, study, words, offered, rng) if inner is not None else None
            if query is not None:
                return query
        return None

    def _with_another(
        self, inner: Query, study: SimulatedScene, words: Words, offered: Targets, rng: np.random.Generator
    ) -> Query | None:
        target, moment = inner.target, inner.moment
        assert target is not None
        assert moment is not None
        for other in offered:
            if other.quantity != target.quantity or other == target:
                continue
            rival = KINDS[inner.kind].at(moment, study, words, {other: offered[other]}, rng)
            is_revealed = Channel(other.subject, other.quantity) in moment.revealed_channels
            if rival is None or rival.moment != moment or is_revealed:
                continue
            query = self.worth(_query(inner, rival), study, words)
            if query is not None:
                return query
        return None

    def number(self, less: float, greater: float) -> float | None:
        """Return the ratio of the greater value to the smaller one."""
        return greater / less if less > 0.0 and greater < MAX_RATIO * less else None

    def measured(self, query: Query) -> Measured:
        """Return the quantity, unit and least value of the answer: a ratio, without unit, of at least 1.1."""
        del query
        return Measured("ratio", "", least=MIN_RATIO)

    def names(self, query: WhichQuery, words: Words) -> tuple[str, str] | None:
        """Return the names of both subjects if the quantity belongs to each, or both noun phrases; else None."""
        nouns = _nouns(query, words)
        if nouns is None:
            return None
        first, second = (_split_phrase(*pair, words) for pair in zip(query.both, nouns, strict=True))
        if first is None or second is None or first[1] != second[1] or _phrase_tail(first[2], second[2]) is None:
            return nouns[0].phrase, nouns[1].phrase
        return first[0], second[0]

    def _property(self, query: WhichQuery, words: Words) -> tuple[str, str] | None:
        """Return the property that decides between two subjects, such as *speed*, and the words after it; else None."""
        names, nouns = self.names(query, words), _nouns(query, words)
        if names is None or nouns is None or names[0] == nouns[0].phrase:
            return None
        first, second = (_split_phrase(*pair, words) for pair in zip(query.both, nouns, strict=True))
        assert first is not None
        assert second is not None
        return first[1], _phrase_tail(first[2], second[2]) or ""

    def option(self, query: WhichQuery, words: Words, number: str, *, first: bool) -> str:
        """Return an option such as *block A, by a factor of 1.41*."""
        names = self.names(query, words)
        assert names is not None
        return f"{names[0 if first else 1]}, by a factor of {number}"

    def conclusion(self, query: WhichQuery, words: Words) -> str:
        """Return a clause such as *block A has the greater kinetic energy, by a factor of*."""
        name, *_ = self.names(query, words) or ("it",)
        named = self._property(query, words)
        return f"{name} {_property_predicate(*named) if named is not None else 'is the greater'}, by a factor of"

    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return the forms of the question: *which of A and B has the greater speed, and by what factor?*."""
        assert isinstance(query, WhichQuery)
        nouns = _nouns(query, words)
        if query.moment is None or noun is None or nouns is None:
            return ()
        whens = [f" {when}" for when in query.moment.phrases(words)]
        sentences, named = list[str](), self._property(query, words)
        for _, first, second in self.orders(query, words):
            for when in whens:
                sentences += (
                    _of_two(first, second, _property_predicate(*named), when)
                    if named
                    else _of_nouns(first, second, when)
                )
        return tuple(dict.fromkeys(sentences))

    def finds(self, words: Words) -> tuple[str, ...]:
        """Return the names of all quantities in the scene."""
        return tuple(quantities_named(words.mechanism))

    def posed(self, asked: StructuredQuestion, study: SimulatedScene, words: Words) -> Query | None:
        """Return the query for two subjects, as in *block A or block B*; None without the *or*."""
        first, separator, second = asked.of.partition(OR)
        if not separator:
            return None
        moment = moment_of(asked, words)
        pair = (
            Query(moment.kind, target_named(StructuredQuestion(asked.find, of, asked.when), words), moment)
            for of in (first, second)
        )
        return self.oriented(_query(*pair), study)

    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield a query for each quantity, two subjects and moment that a text names."""
        del targets
        if not text.lower().startswith(("which ", "determine which ")):
            return
        for group in _groups_by_quantity(
            {t: noun for t, noun in _all_targets(words).items() if _is_named(t, noun, text, words)}
        ):
            for name in INNER:
                parsed_queries = KINDS[name].parsed(text, study, words, {t: _all_targets(words)[t] for t in group})
                of_moment = sorted(parsed_queries, key=lambda query: repr(query.moment))
                for _, queries in groupby(of_moment, key=lambda query: repr(query.moment)):
                    yield from (self.oriented(_query(*pair), study) for pair in combinations(dict.fromkeys(queries), 2))


def _query(first: Query, second: Query) -> WhichQuery:
    return WhichQuery(WhichGreaterKind.name, first.target, first.moment, first.kind, second)


def _all_targets(words: Words) -> Targets:
    return targets(words)


def _is_of_moment(noun: Noun) -> bool:
    """Return whether a phrase names a value at a moment, not a constant or a change over an interval."""
    return not (noun.timeless or noun.interval_phrase or noun.phrase.startswith(AWKWARD))


def _groups_by_quantity(offered: Targets) -> Iterator[list[Target]]:
    """Yield groups of targets that share one quantity."""
    sizes = [target for target, noun in offered.items() if target.sense is None and _is_of_moment(noun)]
    for name in dict.fromkeys(target.quantity for target in sizes):
        group = [target for target in sizes if target.quantity == name]
        if len(group) > 1:
            yield group


def _nouns(query: WhichQuery, words: Words) -> tuple[Noun, Noun] | None:
    nouns = [_all_targets(words).get(each.target) for each in query.both if each.target is not None]
    first, second = nouns if len(nouns) > 1 else (None, None)
    return (first, second) if first is not None and second is not None else None


def _split_phrase(query: Query, noun: Noun, words: Words) -> tuple[str, str, str] | None:
    """Return a phrase's subject, property and rest: *block A*, *speed*, *relative to the ground*; None if it has none.

    The name must not hold an *and*, which would be misunderstood between two names.
    """
    assert query.target is not None
    called = words.subject_phrases(QUANTITIES[query.target.quantity].of)[query.target.subject]
    if " and " in called:
        return None
    if (far := f"the {DISTANCE.format(called)}") in noun.phrase:
        return called, DISTANCE, noun.phrase.removeprefix(far)
    match = re.fullmatch(rf"the ([a-z ]+) (?:of|in) {re.escape(called)}((?: .*)?)", noun.phrase)
    return (called, match[1], match[2]) if match is not None else None


def _is_named(target: Target, noun: Noun, text: str, words: Words) -> bool:
    parts = _split_phrase(Query("", target), noun, words)
    return noun.phrase in text or (parts is not None and parts[0] in text)


def _phrase_tail(first: str, second: str) -> str | None:
    """Return the words after the property of both phrases, such as *relative to the ground*; None if they differ."""
    return first or second if first == second or not (first and second) else None


def _of_two(first: str, second: str, has: str, when: str) -> tuple[str, ...]:
    """Return the sentences for a property of two subjects."""
    return (
        f"which of {first} and {second} {has}{when}, and by what factor?",
        f"which {has}{when}, {first} or {second}, and by what factor?",
        f"determine which of {first} and {second} {has}{when}, and by what factor.",
    )


def _property_predicate(named: str, tail: str) -> str:
    """Return a predicate such as *is faster* or *has the greater kinetic energy*."""
    if named.startswith(MAGNITUDE):
        return f"has the {named.removeprefix(MAGNITUDE)} of greater magnitude{tail}"
    return f"{PROPERTY_PREDICATES.get(named, f'has the greater {named}')}{tail}"


def _of_nouns(first: str, second: str, when: str) -> tuple[str, ...]:
    """Return the sentences for two quantities."""
    return (
        f"which is greater{when}, {first} or {second}, and by what factor?",
        f"which is the greater{when}, {first} or {second}, and by what factor is it greater?",
        f"determine which is greater{when}, {first} or {second}, and by what factor.",
    )
