"""Questions for extreme values, sums and counts over an interval of the motion."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice, tee
from math import nan
from typing import ClassVar

import numpy as np

from sim2reason.base.draws import draw_index
from sim2reason.questions.accuracy import certification_gap
from sim2reason.questions.choices import depends_on_moment, has_formula_of_time
from sim2reason.questions.functionals import FUNCTIONALS, Functional
from sim2reason.questions.functionals.aggregates import PLACELESS
from sim2reason.questions.kinds import Kind, Measured, kind, moments_by_cause
from sim2reason.questions.moments import Happening, Moment
from sim2reason.questions.moments.reached import moment_of
from sim2reason.questions.moments.times import AtTime, WholeMotion
from sim2reason.questions.phrasing import question_sentences, use_pronoun
from sim2reason.questions.query import Noun, Query, Target, Targets
from sim2reason.questions.structured import StructuredQuestion, resolve_name
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.state import Array
from sim2reason.simulation.certify import Certificate

ADVERBS = ("in all", "altogether")  # adverbs that can only end a sentence
MAX_INTERVAL_ENDS = 3  # ends of intervals tried for each functional
MAX_FUNCTIONALS = 5  # functionals tried in one draw
MAX_EVENT_CLASSES = 3  # classes of events used as ends of intervals in one draw


@dataclass(frozen=True, slots=True)
class StretchQuery(Query):
    """A query for a functional of a subject over the interval that ends with the moment."""

    functional: str = ""
    name: str = ""

    @property
    def subject(self) -> str:
        """Return the subject of the functional."""
        return self.name


class StretchKind(Kind):
    """The base class of kinds that ask for a functional from the start to a moment; each functional declares its kind.

    Class data:
        ends_matter: whether the answer depends on the end of the interval. If it does not, no stated number may give
            the end; if it does, and is not an integer, another end must change the answer.
    """

    ends_matter: ClassVar[bool] = True

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a query for a random functional of the motion that is worth asking; None if there is none."""
        del targets
        offers = _functional_subjects(self.name, words)
        return self._compose_query(_ends(study, words, rng), study, words, rng) if offers else None

    def at(
        self, moment: Moment, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator
    ) -> Query | None:
        """Return a query for a functional over the interval that ends with the moment; None without one."""
        del targets
        return self._compose_query([moment], study, words, rng)

    def _compose_query(
        self, ends: Iterable[Moment], study: SimulatedScene, words: Words, rng: np.random.Generator
    ) -> Query | None:
        """Return a query for a functional over an interval with one of the given ends; None without one."""
        offered = [pair for pair in _functional_subjects(self.name, words) if pair[0].drawn_by_recipes]
        if not self.ends_matter:
            ends = (moment for moment in ends if not moment.stated)
        for _ in range(MAX_FUNCTIONALS):
            if not offered:
                break
            names = [functional.name for functional, _ in offered]
            weights = [f.weight / names.count(f.name) for f, _ in offered]
            functional, name = offered.pop(draw_index(rng, weights))
            if rng.random() > functional.weight:  # what is seldom asked is so where little else is offered, too
                continue
            ends, these = tee(ends)  # no end is looked for before it is needed
            for moment in islice(_fitting(these, functional, words, name), MAX_INTERVAL_ENDS):
                query = StretchQuery(self.name, None, moment, functional.name, name)
                if self._is_worth_asking(query, study):
                    return query
        return None

    def _is_worth_asking(self, query: StretchQuery, study: SimulatedScene) -> bool:
        functional, end, answer = FUNCTIONALS[query.functional], _end_time(query, study), _value(query, study)
        if end is None or answer is None or not answer > functional.least:
            return False
        return functional.worth(study, query.name, end) and (self._end_matters(query, study) or self.whole)

    def _end_matters(self, query: StretchQuery, study: SimulatedScene) -> bool:
        """Return whether another end of the interval would change the answer; True for kinds that need no such test."""
        functional, moment = FUNCTIONALS[query.functional], query.moment
        if not self.ends_matter or moment is None:
            return True
        time = study.time(moment)

        def values(times: Array) -> Array:
            sampled = (functional.value(study.trace, query.name, end) for end in times.tolist())
            return np.array([value if value is not None else nan for value in sampled])

        return time is not None and depends_on_moment(moment, study.trace, time, values)

    def answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the value of the functional."""
        assert isinstance(query, StretchQuery)
        return _value(query, study)

    def loose_answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the value of the functional, also an extreme at an end of the interval."""
        assert isinstance(query, StretchQuery)
        value, end = _value(query, study), _end_time(query, study)
        if value is not None or end is None:
            return value
        return FUNCTIONALS[query.functional].loose_value(study.trace, query.name, end)

    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return sentences such as *what is the greatest speed of A before the string first goes slack?*."""
        del noun
        assert isinstance(query, StretchQuery)
        moment, functional = query.moment, FUNCTIONALS[query.functional]
        called = nouns(functional, words).get(query.name)
        if moment is None or called is None:
            return ()
        target = Target(query.functional, query.name)
        return tuple(
            dict.fromkeys(
                shape
                for when in functional.when(moment, words, query.name)
                for shape in question_sentences(target, called, when, use_pronoun(moment, called.phrase, when, words))
                if not (when in ADVERBS and shape.startswith(when))  # *in all, what is …?*
            )
        )

    def noun_phrases(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return noun phrases such as *the greatest speed of A before the string first goes slack*; none for counts."""
        del noun
        assert isinstance(query, StretchQuery)
        moment, functional = query.moment, FUNCTIONALS[query.functional]
        named = nouns(functional, words).get(query.name)
        if moment is None or named is None or self.whole:
            return ()
        whens = [when for when in functional.when(moment, words, query.name) if when not in ADVERBS]
        return tuple(f"{named.phrase} {use_pronoun(moment, named.phrase, when, words)}" for when in whens)

    def finds(self, words: Words) -> tuple[str, ...]:
        """Return the names of all functionals that apply to a subject of the scene."""
        return tuple(functional.name for functional in functionals(self.name) if functional.of.names(words.mechanism))

    def posed(self, asked: StructuredQuestion, study: SimulatedScene, words: Words) -> Query | None:
        """Return the query for a functional from the start to a moment, by default over the whole motion.

        A sum has no end of its own where the motion does not repeat itself, as the number of ever smaller bounces.
        """
        del study
        functional, moment = FUNCTIONALS[asked.find], WholeMotion(asked.find in PLACELESS, not self.ends_matter)
        called = words.subject_phrases(functional.of)
        names = {name: called.get(name, name) for name in functional.of.names(words.mechanism)}
        named = moment_of(asked, words) if asked.when else moment
        end = moment if isinstance(named, WholeMotion) else named
        return StretchQuery(self.name, None, end, functional.name, resolve_name("of", asked.of, names))

    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield a query for every functional, subject and moment that a sentence names."""
        del targets
        mentioned = [
            (functional, name)
            for functional, name in _functional_subjects(self.name, words)
            if nouns(functional, words)[name].occurs_in(text)
        ]
        if not mentioned:
            return
        moments = [moment for cls in moments_by_cause() for moment in cls.parsed(text, study.trace, words)]
        for functional, name in mentioned:
            for moment in moments:
                if functional.when(moment, words, name):
                    yield StretchQuery(self.name, None, moment, functional.name, name)

    def measured(self, query: Query) -> Measured:
        """Return the name, unit and least value of the functional, and whether it is a whole number."""
        assert isinstance(query, StretchQuery)
        functional = FUNCTIONALS[query.functional]
        return Measured(functional.name, functional.unit, functional.least, whole=self.whole)

    def doubt(self, query: Query, study: SimulatedScene, certificate: Certificate | None) -> str:
        """Return why the functional's channels, or events up to its end, are not certified; empty if they are."""
        assert isinstance(query, StretchQuery)
        channels = FUNCTIONALS[query.functional].channels(study.mechanism, query.name)
        return certification_gap(certificate, self.time(query, study), query.moment, channels)


def functionals(kind: str) -> tuple[Functional, ...]:
    """Return all functionals of a kind."""
    return tuple(functional for functional in FUNCTIONALS.values() if functional.kind == kind)


@lru_cache(maxsize=32)
def _functional_subjects(kind: str, words: Words) -> tuple[tuple[Functional, str], ...]:
    """Return all functionals of a kind, with each subject that has it in the text."""
    return tuple((functional, name) for functional in functionals(kind) for name in nouns(functional, words))


@lru_cache(maxsize=128)
def nouns(functional: Functional, words: Words) -> Mapping[str, Noun]:
    """Return the noun phrases of a functional by subject, for all subjects that the text can name."""
    return functional.noun_phrases(words)


@lru_cache(maxsize=32)
def _value(query: StretchQuery, study: SimulatedScene) -> float | None:
    functional, end = FUNCTIONALS[query.functional], _end_time(query, study)
    if end is None or query.name not in functional.of.names(study.mechanism):  # it is held in a changed mechanism
        return None
    return functional.value(study.trace, query.name, end)


def _fitting(ends: Iterable[Moment], functional: Functional, words: Words, name: str) -> Iterator[Moment]:
    return (moment for moment in ends if functional.when(moment, words, name))


def _end_time(query: StretchQuery, study: SimulatedScene) -> float | None:
    """Return the end of the interval, s, just before or at the moment; None if the moment does not occur."""
    if query.moment is None:
        return None
    time = study.time(query.moment)
    return query.moment.evaluation_time(time) if time is not None else None


def _ends(study: SimulatedScene, words: Words, rng: np.random.Generator) -> Iterator[Moment]:
    """Yield moments that may end an interval: the whole motion, some events and a stated time."""
    events = 0
    timed = has_formula_of_time(study.mechanism)
    classes = [cls for cls in moments_by_cause() if cls.drawn_by_recipes and (timed or cls is not AtTime)]
    order: list[int] = rng.permutation(len(classes)).tolist()
    for cls in sorted((classes[number] for number in order), key=_rank):
        happens = issubclass(cls, Happening)
        if happens and events == MAX_EVENT_CLASSES:
            continue
        here = cls.found(study, words, rng)
        if here:
            events += happens
            yield here[int(rng.integers(len(here)))]


def _rank(moment: type[Moment]) -> int:
    """Return the rank of a class of ends: whole motions first, stated times last."""
    return 0 if issubclass(moment, WholeMotion) else 2 if moment is AtTime else 1


@kind
class CountKind(StretchKind):
    """The kind that asks how many events of one type occur in an interval of the motion."""

    name = "count"
    of_symbols = False
    share = 0.12
    whole = True


@kind
class ExtremumKind(StretchKind):
    """The kind that asks for the greatest or least value of a quantity in an interval of the motion."""

    name = "extremum"
    share = 0.3
    ends_matter = False


@kind
class SumKind(StretchKind):
    """The kind that asks for the total of a quantity, such as a distance travelled, in an interval of the motion."""

    name = "sum"
    share = 0.25
