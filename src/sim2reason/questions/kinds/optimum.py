"""Questions for the value of a number that makes an answer greatest or least, or for that extreme answer."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field, replace
from itertools import pairwise, product

import numpy as np

from sim2reason.questions.dependence import FIRST_PASS_VALUES, AnswerFunction, ExtremeSearch, StationaryValue
from sim2reason.questions.kinds import KINDS, Measured, kind
from sim2reason.questions.kinds.nested import (
    NestedKind,
    NestedQuery,
    inner_of,
    is_plain,
    usable_answer,
    variant_certification_gap,
    without_target_and_moment,
)
from sim2reason.questions.query import Noun, Query, Targets
from sim2reason.questions.study import COARSE_STEP_ERROR, SimulatedScene, change_directions
from sim2reason.questions.unknown import Unknown, draw_unknowns, is_usual, range_of
from sim2reason.questions.words import Words
from sim2reason.simulation.certify import Certificate
from sim2reason.simulation.trace import DEFAULT_STEP_RTOL, Channel

DRAWS = {"start": 1, "event": 3, "period": 1}  # weights of the kinds of inner questions
MAX_EXAMINED_PAIRS = 2  # candidate pairs of a question and a number that are examined closely
ARGUMENT_SHARE = 0.6  # of questions for an optimum: the share that asks for the number, not the extreme answer
MIN_RELATIVE_CHANGE = (
    0.05  # relative: least difference between the extreme and the answers at the ends of the usual range
)
RANGE_STRIDE = 6  # stride through the points of a range
WITNESS_RELATIVE_DISTANCE = 0.15  # relative: distance on either side at which the second engine is compared
WITNESS_RTOL = 2e-3  # relative: least difference of the answers there, so that the engines can resolve it
RIGHT_ANGLE_DEGREES = 90.0  # degrees: a trivial optimum
EXTREME_WORDS = {True: ("greatest", "as large"), False: ("least", "as small")}
EXTREMES = "greatest", "least"  # words that a noun phrase must not contain to ask for its extreme


@dataclass(frozen=True, slots=True)
class OptimumQuery(NestedQuery):
    """A query for the value of a number that makes another query's answer greatest or least, or for that answer."""

    unit: str = ""
    greatest: bool = True
    asks_place: bool = True
    about: float = field(default=0.0, compare=False)  # where it is, if that is known of a scene like this one

    @property
    def hides(self) -> str:
        """Return the address of the number, which the text leaves open."""
        return self.path

    def extreme(self, study: SimulatedScene) -> StationaryValue | None:
        """Return the extreme in a scene, searched near a known one or over the usual range; None if there is none."""
        error = study.trace.tolerance or DEFAULT_STEP_RTOL
        return study.memoize(
            ("extreme", self.inner, self.path, self.greatest, self.about), lambda: self._found(study, error)
        )

    def _found(self, study: SimulatedScene, error: float) -> StationaryValue | None:
        point = ExtremeSearch(AnswerFunction(self.inner, study, self.path, error))
        if self.about:
            extreme = point.find_extreme_near(self.about, greatest=self.greatest)
            if extreme is not None:
                return extreme
        extreme = point.among(usual_values(study, self.path))
        return extreme if extreme is not None and extreme.greatest is self.greatest else None

    def place(self, study: SimulatedScene) -> float | None:
        """Return the optimal value of the number in a scene; None if there is none."""
        extreme = self.extreme(study)
        return extreme.argument if extreme is not None else None


@kind
class OptimumKind(NestedKind):
    """The kind that asks for the value of a number that makes an answer greatest or least, or for that answer."""

    name = "optimum"
    share = 0.08
    beyond_laws = True
    hides = True
    inner = ("start", "event", "period")

    def draw(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> Query | None:
        """Return a random query whose answer has an interior extreme and is worth asking; None if there is none."""
        if study.mechanism is not study.scene.mechanism:
            return None
        inners = self._drawn(study, words, targets, rng)
        paths = list(self._draw_number_paths(study, words, rng)) if inners else []
        pairs = [(inner, path) for path in paths for inner in inners if _turns(inner, path, study)]
        order: list[int] = rng.permutation(len(pairs)).tolist()
        queries = (self._compose_query(*pairs[number], study, rng) for number in order[:MAX_EXAMINED_PAIRS])
        return next((query for query in queries if query is not None), None)

    def _drawn(self, study: SimulatedScene, words: Words, targets: Targets, rng: np.random.Generator) -> list[Query]:
        """Return random inner queries of other kinds."""
        queries = dict[Query, None]()
        for name in self.inner:
            for _ in range(DRAWS[name]):
                inner = KINDS[name].draw(study, words, targets, rng)
                if inner is not None and is_plain(inner) and self._is_named(inner, words, targets):
                    queries[inner] = None
        return list(queries)

    def _draw_number_paths(self, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Iterable[str]:
        """Return addresses of numbers that the text may leave unknown, angles and lengths first."""
        return [unknown.path for unknown in sorted(draw_unknowns(words.unknowns, study.scene, rng), key=_is_no_shape)]

    def _can_be_about(self, name: str) -> bool:
        """Return whether a phrase does not itself name an extreme value."""
        return super()._can_be_about(name) and not any(word in name for word in EXTREMES)

    def _compose_query(self, inner: Query, path: str, study: SimulatedScene, rng: np.random.Generator) -> Query | None:
        """Return a query with a distinct, smooth extreme in the usual range; None if there is none."""
        values = usual_values(study, path)
        answers = AnswerFunction(inner, study, path, COARSE_STEP_ERROR)
        rough = ExtremeSearch(answers).among(values) if len(values) > 2 else None
        unit = next(p.measure.unit for p in study.scene.parameters if p.path == path)
        right = unit == "deg" and rough is not None and abs(rough.argument - RIGHT_ANGLE_DEGREES) < 1.0
        if rough is None or right or not is_usual(study.scene, path, rough.argument) or rough.value <= _least(inner):
            return None
        ends = [answers(values[0]), answers(values[-1])]
        if any(end is None or not _is_clear(rough, end) for end in ends):
            return None
        sides = [
            answers.course(rough.argument * (1.0 + side))
            for side in (-WITNESS_RELATIVE_DISTANCE, 0.0, WITNESS_RELATIVE_DISTANCE)
        ]
        if None in sides or sides[0] != sides[1] or sides[1] != sides[2]:
            return None
        query = OptimumQuery(
            self.name, inner.target, inner.moment, without_target_and_moment(inner), path, unit, rough.greatest
        )
        query = replace(query, asks_place=bool(rng.random() < ARGUMENT_SHARE), about=rough.argument)
        optimum = query.place(study)
        return replace(query, about=optimum) if optimum is not None else None

    def answer(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the optimal number, or the extreme answer."""
        assert isinstance(query, OptimumQuery)
        extreme = query.extreme(study)
        if extreme is None:
            return None
        return extreme.argument if query.asks_place else extreme.value

    def with_likely_answer(self, query: Query, answer: float) -> Query:
        """Return a query that contains the likely optimum."""
        assert isinstance(query, OptimumQuery)
        return replace(query, about=answer) if query.asks_place else query

    def time(self, query: Query, study: SimulatedScene) -> float | None:
        """Return the time, s, by which the inner query has its answer in the recorded motion; zero without one."""
        inner = inner_of(query)
        return KINDS[inner.kind].time(inner, study) or 0.0

    def measured(self, query: Query) -> Measured:
        """Return the unit and least value of the number or, if it is asked for, of the extreme answer."""
        assert isinstance(query, OptimumQuery)
        if query.asks_place:
            return Measured("optimum", query.unit, least=0.0)
        inner_measure = KINDS[query.inner.kind].measured(query.inner)
        return Measured("extreme value", inner_measure.unit, inner_measure.least)

    def channels(self, query: Query) -> tuple[Channel, ...]:
        """Return no channels, as the recorded motion does not determine the answer."""
        del query
        return ()

    def doubt(self, query: Query, study: SimulatedScene, certificate: Certificate | None) -> str:
        """Return why the extreme is not unique in the range, or not confirmed by both engines; empty if it is."""
        del certificate
        assert isinstance(query, OptimumQuery)
        extreme = query.extreme(study)
        if extreme is None:
            return "there is no extreme"
        answers = AnswerFunction(query.inner, study, query.path, COARSE_STEP_ERROR)
        values = range_of(study.scene, query.path)[::RANGE_STRIDE]
        seen = [answer for value in values if (answer := answers(value)) is not None]
        if any((answer > extreme.value) is query.greatest and answer != extreme.value for answer in seen):
            return "elsewhere the answer is beyond the extreme"
        for side in (-WITNESS_RELATIVE_DISTANCE, 0.0, WITNESS_RELATIVE_DISTANCE):
            value = answers(extreme.argument * (1.0 + side))
            if value is None or (side and abs(value / extreme.value - 1.0) < WITNESS_RTOL):
                return "the extreme is too flat to be told"
            other = study.with_same_change({query.path: extreme.argument * (1.0 + side)})
            if (
                reason := variant_certification_gap(query.inner, other)
                if other is not None
                else "there is no motion beside the extreme"
            ):
                return reason
        return ""

    def shapes(self, query: Query, words: Words, noun: Noun | None) -> tuple[str, ...]:
        """Return sentences such as *find the mass of A for which the kinetic energy of B … is greatest*."""
        assert isinstance(query, OptimumQuery)
        unknown = next((candidate for candidate in words.unknowns if candidate.path == query.path), None)
        if unknown is None:
            return ()
        extreme, size = ("greatest", "large") if query.greatest else ("least", "small")
        pairs = list(product(unknown.phrases, self.names(query, words, noun)))
        if query.asks_place:
            return tuple(
                shape
                for phrase, name in pairs
                for shape in (
                    f"find {_value_phrase(phrase)} for which {name} is {extreme}.",
                    f"what must {phrase} be for {name} to be as {size} as possible?",
                    f"determine {_value_phrase(phrase)} that makes {name} as {size} as possible.",
                )
            )
        return tuple(
            shape
            for phrase, name in pairs
            for shape in (
                f"{phrase} can be chosen freely: what is the {extreme} possible value of {name}?",
                f"find the {extreme} value of {name} that a suitable choice of {phrase} can give.",
                f"determine the {extreme} possible value of {name}, if {phrase} can be chosen freely.",
            )
            if shape[0].isalpha()
        )

    def parsed(self, text: str, study: SimulatedScene, words: Words, targets: Targets) -> Iterator[Query]:
        """Yield a query for every extreme of a quantity that a sentence names, with every unknown number."""
        extremes = [
            great
            for great, phrases in ((True, ("greatest", "as large")), (False, ("least", "as small")))
            if any(map(text.__contains__, phrases))
        ]
        if not extremes or not words.unknowns:
            return
        for inner in self.inner_parsed(text, study, words, targets):
            for unknown, greatest, asks_place in product(words.unknowns, extremes, (True, False)):
                yield OptimumQuery(
                    self.name,
                    inner.target,
                    inner.moment,
                    without_target_and_moment(inner),
                    unknown.path,
                    unknown.unit,
                    greatest,
                    asks_place,
                )


def _turns(inner: Query, path: str, study: SimulatedScene) -> bool:
    """Return whether an answer has one interior extreme over a few values of a number."""
    values = usual_values(study, path)
    if len(values) < FIRST_PASS_VALUES:
        return False
    answers, courses = list[float](), set[tuple[float, ...]]()
    for value in (values[n * (len(values) - 1) // (FIRST_PASS_VALUES - 1)] for n in range(FIRST_PASS_VALUES)):
        other = study.with_values({path: value})
        answer = usable_answer(inner, other, loosely=True)
        if other is None or answer is None:
            return False
        answers.append(answer)
        courses.add(change_directions(other, KINDS[inner.kind].time(inner, other) or 0.0))
        if len(courses) > 1:
            return False  # where something turns round, a size passes through zero
    rises = [after > before for before, after in pairwise(answers)]
    return sum(one != other for one, other in pairwise(rises)) == 1


def _is_no_shape(unknown: Unknown) -> bool:
    return unknown.unit not in ("deg", "m")


def usual_values(study: SimulatedScene, path: str) -> list[float]:
    """Return points of the usual range of a number, in ascending order."""
    values = range_of(study.scene, path)
    return [value for value in values if is_usual(study.scene, path, value)][::2]


def _is_clear(extreme: StationaryValue, end: float | None) -> bool:
    """Return whether an answer at an end of the range differs clearly from the extreme, on the right side."""
    if end is None:
        return False
    beyond = (extreme.value - end) if extreme.greatest else (end - extreme.value)
    return beyond > MIN_RELATIVE_CHANGE * abs(extreme.value)


def _least(inner: Query) -> float:
    return KINDS[inner.kind].measured(inner).least


def _value_phrase(phrase: str) -> str:
    """Return the noun phrase for a value: *the mass of block A*, *the value of m*."""
    return phrase if phrase.startswith("the ") else f"the value of {phrase}"
