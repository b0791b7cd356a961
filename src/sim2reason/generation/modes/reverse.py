"""The reverse mode: an unknown number or time is sought for which a stated result occurs."""

from collections.abc import Iterator, Mapping
from math import isfinite
from typing import ClassVar

import numpy as np

from sim2reason.generation.modes.problem_formula import likely_answers
from sim2reason.questions import (
    KINDS,
    Kind,
    Noun,
    ParsedQuestion,
    Query,
    Question,
    QuestionMode,
    SimulatedScene,
    StatedResult,
    Suits,
    Words,
    accepts_any_query,
    mode,
)
from sim2reason.questions.conditions import UniquenessScan, asking_for
from sim2reason.questions.dependence import RELATIVE_STEP, AnswerFunction
from sim2reason.questions.inversion import values_giving, why_not_one
from sim2reason.questions.kinds import kinds_by_share
from sim2reason.questions.moments.reached import Reached
from sim2reason.questions.phrasing import draw_sentence, sentence
from sim2reason.questions.query import Target, targets
from sim2reason.questions.sentences import plainly
from sim2reason.questions.study import COARSE_STEP_ERROR, EXACT_STEP_ERROR
from sim2reason.questions.unknown import Unknown, draw_unknowns, far_from, lengthen_strings, range_of

ANSWER_RTOL = 1e-2  # relative accuracy to which the given result must determine the answer
RESULT_DIGITS = 3  # significant digits of the given result
MAX_DRAWS = 3  # queries of one kind, at most, until one is suitable
EXACT_DIGITS = 15  # digits of a result of the drawn motion
NEAR_MATCH_RTOL = 1e-2  # relative distance that counts as a near match
TIMES = {"": 0.03, "time_to_event": 0.08}  # probability that a time is unknown: for all kinds, or for one


@mode
class Reverse(QuestionMode):
    """Question for the number, or time, for which a stated result occurs."""

    name = "reverse"
    weights: ClassVar[Mapping[str, float]] = {  # seldom measured
        "sum": 0.03,
        "state": 0.1,
        "threshold": 0.4,
        "comparison": 0.0,
    }

    @property
    def kinds(self) -> frozenset[str]:
        """Return the kinds whose answers can be stated as conditions and are not integers."""
        return frozenset(name for name, kind in KINDS.items() if kind.stated and not kind.whole)

    def ask(
        self, study: SimulatedScene, words: Words, kind: str, rng: np.random.Generator, suits: Suits = accepts_any_query
    ) -> Question | None:
        """Return a question with a result of this motion and an unknown number, or time, that it determines."""
        if kind in TIMES and rng.random() < TIMES[kind]:
            return _asking_when(study, words, rng, suits)
        questions = (
            self._ask_query(question_kind, study, words, rng, suits)
            for question_kind in ([KINDS[kind]] if kind else kinds_by_share(rng))
        )
        return next((question for question in questions if question is not None), None)

    def _ask_query(
        self, asked: Kind, study: SimulatedScene, words: Words, rng: np.random.Generator, suits: Suits
    ) -> Question | None:
        for _ in range(MAX_DRAWS if asked.stated else 0):
            query = asked.draw(study, words, targets(words), rng)
            if query is None or not asked.noun_phrases(query, words, _noun(query, words)):
                return None
            result = asked.answer(query, study)
            if result is None or not isfinite(result):
                return None
            unit = words.units.spell(asked.measured(query).unit)
            exact = StatedResult.rounded(result, unit, EXACT_DIGITS)
            attempted = False
            for unknown in draw_unknowns(_possible_unknowns(query, words), study.scene, rng):
                if exact is None or not suits(query, unknown.path, exact):
                    continue
                attempted = True
                question = self._with_unknown(query, unknown, result, study, words, rng)
                if question is not None:
                    return question
            if attempted:
                return None
        return None

    def _with_unknown(
        self,
        query: Query,
        unknown: Unknown,
        result: float,
        study: SimulatedScene,
        words: Words,
        rng: np.random.Generator,
    ) -> Question | None:
        """Return the question for an unknown number that the given result determines; None if it does not."""
        kind = KINDS[query.kind]
        fixed = study.memoize(  # queries are drawn repeatedly
            ("fixed", query, unknown.path), lambda: _fixed_result(query, unknown, result, study, words)
        )
        values = range_of(study.scene, unknown.path)
        if fixed is None or not values[0] <= fixed[1] <= values[-1]:
            return None
        given, answer, elasticity = fixed
        query = kind.with_likely_answer(query, given.value)
        text = sentence(draw_sentence(asking_for(unknown, query, given, words, _noun(query, words)), rng))
        return Question(self.name, query, text, answer, unknown.unit, "", unknown.path, given, elasticity)

    def study(self, question: Question, study: SimulatedScene) -> SimulatedScene:
        """Return the motion that has exactly the stated result."""
        if not question.unknown:
            return study
        return SimulatedScene.of(study.scene.having(question.unknown, question.answer), study.trace.state.times)

    def response(self, question: Question, study: SimulatedScene, other: SimulatedScene) -> float | None:
        """Return the answer in a changed scene, to first order: ln p changes by ln(R/R')/elasticity for result R."""
        result = super().response(question, study, other)
        if result is None or question.given is None or not question.unknown:
            return result
        ratio = result / question.given.value
        if ratio <= 0.0:
            return question.answer * (1.0 - (ratio - 1.0) / question.elasticity)
        return question.answer * float(np.exp(-np.log(ratio) / question.elasticity))

    def parsed(self, text: str, study: SimulatedScene, words: Words) -> ParsedQuestion | None:
        """Parse a sentence that asks for which number, or when, a result occurs; None if it is no such sentence."""
        readings = dict.fromkeys((text, plainly(text, words.units)))  # digits tell how close a result is
        return next(
            (question for reading in readings if (question := self._read(reading, study, words)) is not None), None
        )

    def _read(self, text: str, study: SimulatedScene, words: Words) -> ParsedQuestion | None:
        """Return the reverse question that a sentence asks, with its numbers as written; None if it asks none."""
        variants = f"{text}\n{text[0].lower()}{text[1:]}"  # a name may stand at the beginning
        for unknown in words.unknowns:
            for query, unit in _stated(variants, study, words):
                if any(other.path not in (unknown.path, query.hides) for other in words.unknowns):
                    continue
                noun = _noun(query, words)
                for given in dict.fromkeys(StatedResult.find_in_text(text, unit)):
                    if any(sentence(shape) == text for shape in asking_for(unknown, query, given, words, noun)):
                        return ParsedQuestion(self.name, query, given)
        for moment in Reached.parsed(text, study.trace, words) if not words.unknowns else ():
            query = Query("time_to_event", None, moment)
            if any(sentence(shape) == text for shape in KINDS[query.kind].shapes(query, words, None)):
                return ParsedQuestion(self.name, query, moment.given)
        return None

    def solution(self, asked: ParsedQuestion, study: SimulatedScene, words: Words) -> float | None:
        """Return the only value of the unknown for which the stated result occurs; None if there is not exactly one."""
        if asked.given is None or isinstance(asked.query.moment, Reached):
            return super().solution(asked, study, words)
        for unknown in _possible_unknowns(asked.query, words):
            values = values_giving(asked.query, asked.given.value, unknown, study)
            return values[0] if len(values) == 1 else None
        return None

    def lacking(self, asked: ParsedQuestion, study: SimulatedScene, words: Words) -> str:
        """Return why the stated result fixes no value of the unknown number: none gives it, or several do."""
        unknown = next(iter(_possible_unknowns(asked.query, words)), None)
        if asked.given is None or unknown is None or isinstance(asked.query.moment, Reached):
            return super().lacking(asked, study, words)
        return why_not_one(unknown, values_giving(asked.query, asked.given.value, unknown, study), study.scene)


def why_undetermined(question: Question, study: SimulatedScene, words: Words) -> str:
    """Return why a result does not determine the unknown: another value or a near limit; empty if it does.

    Strings and edges are given enough clearance, because no text states how far they let bodies move.
    """
    if question.given is None or not question.unknown:
        return ""
    scene = lengthen_strings(study.scene)
    likely = likely_answers(question.query, study, words, question.unknown)
    fine = AnswerFunction(question.query, study, question.unknown, EXACT_STEP_ERROR, scene, likely)
    if scene is study.scene:
        fine.record_answer(question.answer, question.given.value)
    scan = UniquenessScan(
        fine, question.answer, question.given.value, question.given.half, fine.coarser(COARSE_STEP_ERROR)
    )
    values = range_of(study.scene, question.unknown, question.answer)
    edge = scan.find_missing_answer(values)
    if edge is not None:
        return f"edge: at {edge:.3g} {question.unit} there is no result"
    other = scan.find_other_root(values)
    if other is not None and fine.is_late(other):
        return f"late: at {other:.3g} {question.unit} it comes after the motion that is followed, if it does"
    if other is not None:
        return f"another: {other:.3g} {question.unit} is not excluded"
    end = scan.find_extrapolated_root(values)
    if end is not None:
        return f"end: behind {end:.3g} {question.unit} there may be another number"
    far = scan.find_distant_root(far_from(values, question.answer, question.unit))
    return f"far: {far:.3g} {question.unit} is not excluded, or a number before it" if far is not None else ""


def _possible_unknowns(query: Query, words: Words) -> list[Unknown]:
    """Return the numbers that may be the unknown, except the one whose limit the query itself asks for.

    Numbers with the same symbol as that one are excluded too.
    """
    symbols = {unknown.symbol for unknown in words.unknowns if unknown.path == query.hides}
    return [unknown for unknown in words.unknowns if unknown.path != query.hides and unknown.symbol not in symbols]


def _noun(query: Query, words: Words) -> Noun | None:
    return targets(words)[query.target] if query.target is not None else None


def _fixed_result(
    query: Query, unknown: Unknown, result: float, study: SimulatedScene, words: Words
) -> tuple[StatedResult, float, float] | None:
    """Return the rounded result of a query, the unknown number that gives exactly it, and the elasticity, if any."""
    likely = likely_answers(query, study, words, unknown.path)
    dependence = AnswerFunction(query, study, unknown.path, likely=likely)
    drawn = float(study.scene.value(unknown.path))
    dependence.record_answer(drawn, result)
    return _fixed(dependence, drawn, result, words.units.spell(KINDS[query.kind].measured(query).unit))


def _fixed(
    dependence: AnswerFunction, drawn: float, result: float, unit: str
) -> tuple[StatedResult, float, float] | None:
    """Return the rounded result, the number that gives exactly it, and the elasticity; None without such a number."""
    rate = dependence.rate(drawn)
    if not rate:
        return None
    given = StatedResult.rounded(result, unit, RESULT_DIGITS)
    if given is None or given.half > ANSWER_RTOL * abs(rate * drawn):
        return None
    answer = dependence.solve_from(given.value, drawn)
    if answer is None or abs(answer - drawn) > ANSWER_RTOL * abs(drawn):
        return None
    return given, answer, rate * drawn / result


def _stated(text: str, study: SimulatedScene, words: Words) -> Iterator[tuple[Query, str]]:
    """Yield all queries whose result a sentence could state, each with the unit of its answer."""
    named = {target: noun for target, noun in targets(words).items() if noun.occurs_in(text)}
    for kind in KINDS.values():
        for query in dict.fromkeys(kind.parsed(text, study, words, named)):
            yield query, words.units.spell(kind.measured(query).unit)


def _asking_when(study: SimulatedScene, words: Words, rng: np.random.Generator, suits: Suits) -> Question | None:
    """Return a question for the time when a quantity first has a value."""
    drawn = KINDS["state"].draw(study, words, targets(words), rng)
    time = study.time(drawn.moment) if drawn is not None and drawn.moment is not None else None
    if drawn is None or drawn.target is None or time is None:
        return None
    value, later = (drawn.target.value(study.trace.at(when)) for when in (time, time * (1.0 + RELATIVE_STEP)))
    given = (
        StatedResult.rounded(value, words.units.spell(drawn.target.unit), RESULT_DIGITS) if isfinite(value) else None
    )
    if given is None or given.half > ANSWER_RTOL * abs(later - value) / RELATIVE_STEP:
        return None
    query = Query("time_to_event", None, Reached(drawn.target, given))
    answer = KINDS[query.kind].answer(query, study)
    fixed = answer is not None and abs(answer - time) <= ANSWER_RTOL * time
    if answer is None or not fixed or _comes_close_before(drawn.target, given, answer, study):
        return None
    if not suits(query, "", given):
        return None
    text = sentence(draw_sentence(KINDS[query.kind].shapes(query, words, None), rng))
    return Question("reverse", query, text, answer, words.units.time, given=given)


def _comes_close_before(target: Target, given: StatedResult, time: float, study: SimulatedScene) -> bool:
    """Return whether a quantity already comes close to its stated value before the time when it reaches it."""
    scan = study.trace.scan
    away = np.abs(target.values(scan)[scan.times < time] - given.value)
    near = away <= max(given.half, NEAR_MATCH_RTOL * abs(given.value))
    coming = len(near) - int(np.argmin(near[::-1])) if not near.all() else 0  # since when it is near for good
    return bool(near[:coming].any() or (np.diff(away[coming:]) > 0.0).any())
