"""Search for related questions about one scene, which become the parts of a problem.

One part leads to another if its answer is an intermediate result of the other's worked solution, or the time of the
other's moment. Candidates are intermediate results of solutions, and further questions about the same moments. Each
part passes every filter by itself; the difficulty is that of all parts together, so that a later part may be easier
than its label.
"""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import pi

import numpy as np

from sim2reason.generation.certified import CertifiedPart, CertifiedQuestion
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.questions import KINDS, Moment, Query, Question, QuestionMode, SimulatedScene, Target
from sim2reason.questions.accuracy import TOLERANCE
from sim2reason.questions.choices import is_constant, is_large_enough, is_worth_asking_at
from sim2reason.questions.difficulty import Difficulty
from sim2reason.questions.kinds.stretches import StretchKind
from sim2reason.questions.moments import Happening
from sim2reason.questions.moments.times import AllAlong, AtStart
from sim2reason.questions.prompt_formats import build_part_prompt
from sim2reason.questions.query import Targets, targets
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.simulation.trace import Channel
from sim2reason.solutions import ProblemContext, Solution, solve
from sim2reason.solutions.algebra.expressions import Symbol

NUMBERS: dict[Difficulty, tuple[int, ...]] = {"easy": (2,), "medium": (2, 3), "hard": (3, 4)}
"""How many parts a problem has, each number as often."""
MIN_PARTS = 2
LOOKED_AT, SIFTED = 16, 6  # candidates that are solved, and those of them that are filtered
SURE_FIRST = 0.7  # probability that questions certainly related to a part are tried first
QUESTIONS_PER_KIND = 2  # further questions of a kind about one moment
SAME_VALUE_RTOL = 1e-9  # relative; closer values belong to one quantity
TRIVIAL_RTOL = 1e-6  # relative; ratios this close to a simple number are trivial
MAX_NUMERATOR = 8  # numerator and denominator of a simple number
NOTHING_LEADS = "parts: no two lead to each other"
SETTINGS = NUMBERS, MIN_PARTS, LOOKED_AT, SIFTED, QUESTIONS_PER_KIND


@dataclass(frozen=True)
class _Part:
    """A part of a multipart problem in the search: a certified question with its worked solution."""

    certified: CertifiedQuestion
    solution: Solution

    @property
    def question(self) -> Question:
        """Return the question."""
        return self.certified.question

    def follows(self, other: "_Part") -> bool:
        """Return whether this part's solution uses the answer to the other part."""
        return _leads(other.question, other.solution, self.question, self.solution)


class PartSearch:
    """The search for the parts of a problem about one scene, starting from one question."""

    def __init__(
        self,
        search: QuestionSearch,
        mode: QuestionMode,
        difficulty: Difficulty,
        rng: np.random.Generator,
        refused: Counter[str],
    ) -> None:
        """Store the scene, the mode and a random generator; `refused` counts rejections by filter."""
        self._search, self._mode, self._rng, self._refused = search, mode, rng, refused
        numbers = NUMBERS[difficulty]
        self._number = numbers[int(rng.random() * len(numbers))]
        self._looks, self._sifts = LOOKED_AT, SIFTED

    def around(self, found: CertifiedQuestion) -> CertifiedQuestion | None:
        """Return a multi-part problem that includes `found`; None if no related part is found."""
        parts, queries = [_Part(found, solve(found.setting))], {found.question.query}
        while len(parts) < self._number and (len(parts) > 1 or self._may_be_joined(parts[0])):
            more = self._one_more(parts, queries)
            if more is None:
                break
            parts.append(more)
        if len(parts) < max(MIN_PARTS, self._number - 1):
            self._refused[NOTHING_LEADS] += 1
            return None
        return self._as_one(parts)

    def _one_more(self, parts: list[_Part], asked: set[Query]) -> _Part | None:
        """Return a new part related to one of the others, or None; earlier candidates are not repeated."""
        for query in self._offered(parts):
            if query in asked:
                continue
            if min(self._looks, self._sifts) <= 0:
                return None
            asked.add(query)
            question = self._mode.asking(query, self._search.study, self._search.words, self._rng)
            if question is None or not all(is_new(question, part.question, self._search.study) for part in parts):
                continue
            self._looks -= 1
            solution = solve(self._setting(question))
            if not any(self._joined(question, solution, part) for part in parts):
                continue
            self._sifts -= 1
            beside = tuple(part.certified.candidate for part in parts)
            certified = self._search.certified(question, self._mode, self._rng, self._refused, beside)
            if certified is not None:
                return _Part(certified, solution)
        return None

    def _may_be_joined(self, part: _Part) -> bool:
        """Return whether another part can help to solve this one, by an intermediate result or the time of an event."""
        return bool(_intermediate_results(part.solution)) or isinstance(part.question.query.moment, Happening)

    def _setting(self, question: Question) -> ProblemContext:
        search = self._search
        return ProblemContext.from_query(question, search.study, search.words, search.description)

    def _joined(self, question: Question, solution: Solution, part: _Part) -> bool:
        """Return whether the answer to one of two questions is used in the solution of the other."""
        here, there = (question, solution), (part.question, part.solution)
        return _leads(*here, *there) or _leads(*there, *here)

    def _offered(self, parts: list[_Part]) -> Iterator[Query]:
        """Yield candidate questions in random order, usually first those whose answers a part's solution uses."""
        first = self._rng.random() < SURE_FIRST
        if not first:
            yield from self._others(parts)
        sure = [query for part in parts for query in self._on_the_way(part)]
        yield from (sure[number] for number in self._rng.permutation(len(sure)).tolist())
        if first:
            yield from self._others(parts)

    def _on_the_way(self, part: _Part) -> Iterator[Query]:
        """Yield questions for the intermediate results of a part's solution, and for the time of its moment."""
        study, moments = self._search.study, _moments([part])
        values = list(_intermediate_results(part.solution).values())
        for when in moments:
            yield from self._queries_at("time_to_event", when)
            at = study.time(when)
            if at is None:
                continue
            state = study.trace.at(when.evaluation_time(at))
            for target in self._targets:
                value = target.value(state)
                if any(_is_same_value(value, known) for known, _ in values):
                    yield from _query(target, when, study)

    def _others(self, parts: list[_Part]) -> Iterator[Query]:
        """Yield questions about the start and the moments of the parts, then one of each kind about anything."""
        search, kinds = self._search, sorted(self._mode.kinds)
        pairs: list[tuple[str, Moment]] = [(name, moment) for moment in _moments(parts) for name in kinds]
        order: list[int] = self._rng.permutation(QUESTIONS_PER_KIND * len(pairs)).tolist()
        for number in order:
            yield from self._queries_at(*pairs[number // QUESTIONS_PER_KIND])
        order = self._rng.permutation(len(kinds)).tolist()
        for number in order:
            query = KINDS[kinds[number]].draw(search.study, search.words, self._targets, self._rng)
            yield from [query] if query is not None else []

    def _queries_at(self, kind: str, moment: Moment) -> Iterator[Query]:
        """Yield a question of one kind about a moment, if there is one."""
        search = self._search
        query = KINDS[kind].at(moment, search.study, search.words, self._targets, self._rng)
        yield from [query] if query is not None else []

    @property
    def _targets(self) -> Targets:
        return targets(self._search.words)

    def _as_one(self, parts: list[_Part]) -> CertifiedQuestion:
        """Return the parts as one certified question with a common prompt, in the order in which they are asked."""
        ordered = self._ordered(parts)
        questions = [part.question for part in ordered]
        description = self._search.described(questions)
        prompt, texts = build_part_prompt(description, questions, self._search.words, self._rng)
        certified_parts = tuple(
            CertifiedPart(
                part.certified, part.solution, texts[k], tuple(n for n in range(k) if part.follows(ordered[n]))
            )
            for k, part in enumerate(ordered)
        )
        return replace(
            ordered[-1].certified, description=description, shape=prompt.shape, parts=certified_parts, text=prompt.text
        )

    def _ordered(self, parts: list[_Part]) -> list[_Part]:
        """Return the parts sorted: each after those that lead to it, then by time and length of solution."""

        def place(part: _Part) -> tuple[float, int]:
            query = part.question.query
            return (KINDS[query.kind].time(query, self._search.study) or 0.0, len(part.solution.steps))

        waiting, ordered = sorted(parts, key=place), list[_Part]()
        while waiting:
            ready = (part for part in waiting if not any(part.follows(other) for other in waiting if other is not part))
            ordered.append(next(ready, waiting[0]))
            waiting.remove(ordered[-1])
        return ordered


def _moments(parts: list[_Part]) -> list[Moment]:
    """Return the start, and the moments of the parts."""
    part_moments = [part.question.query.moment for part in parts]
    moments: list[Moment] = [AtStart(), *(moment for moment in part_moments if moment is not None)]
    return list(dict.fromkeys(moments))


def _query(target: Target, when: Moment, study: SimulatedScene) -> Iterator[Query]:
    """Yield the question for a quantity at a moment, if its kind allows one and the answer is not trivial."""
    if when.kind != AtStart.kind:
        revealed = Channel(target.subject, target.quantity) in when.revealed_channels
        if when.kind in KINDS and not revealed and is_worth_asking_at(study, when)(target):
            yield Query(when.kind, target, when)
    elif QUANTITIES[target.quantity].immediate and is_large_enough(target.value(study.trace.at(0.0)), target, study):
        yield Query(AtStart.kind, target, AllAlong() if is_constant(target, study.trace) else AtStart())


def _leads(question: Question, solution: Solution, other: Question, to: Solution) -> bool:
    """Return whether the answer to a question is used in another: as an intermediate result, or as its time."""
    kind = KINDS[other.query.kind]
    hangs_on_end = not isinstance(kind, StretchKind) or kind.ends_matter
    if question.query.kind == "time_to_event" and question.query.moment == other.query.moment and hangs_on_end:
        return True
    if solution.answer is None or to.answer is None:
        return False
    value, unit = solution.values[solution.goal], solution.unit
    return any(
        _is_same_value(value, known) and unit == known_unit for known, known_unit in _intermediate_results(to).values()
    )


def _intermediate_results(solution: Solution) -> dict[str, tuple[float, str]]:
    """Return the values and units of a solution's intermediate results, by name."""
    results = (r for r in solution.relations if r.unit and isinstance(r.left, Symbol) and r.role in ("law", "result"))
    names = {relation.left.latex(): relation.unit for relation in results}
    return {
        name: (solution.values[name], unit)
        for name, unit in names.items()
        if name != solution.goal and name in solution.values
    }


def _is_same_value(value: float, other: float) -> bool:
    return abs(value - other) <= SAME_VALUE_RTOL * abs(value)


def is_new(question: Question, other: Question, study: SimulatedScene) -> bool:
    """Return whether neither of two questions reveals or trivially implies the answer to the other.

    An answer follows trivially if it is a simple multiple of the other, of its square or of its inverse, or such a
    multiple times a stated number: K = m v²/2, W = F d, f = 1/T. The questions must not state numbers for different
    moments either.
    """
    if question.unit == other.unit and abs(question.answer - other.answer) <= TOLERANCE * abs(other.answer):
        return False
    moments = [each.query.moment for each in (question, other)]
    if moments[0] != moments[1] and all(moment is not None and moment.stated for moment in moments):
        return False
    if any(_tells(*pair) for pair in ((question, other), (other, question))):
        return False
    first, second = abs(question.answer), abs(other.answer)
    ratios = (first / second, first / second**2, second / first**2, first * second)
    stated = [abs(p.value) for p in study.scene.parameters if p.value and not p.hidden]
    stated += [abs(number) for moment in moments if moment is not None for number, _ in moment.stated if number]
    factors = [1.0, *stated, *(1.0 / value for value in stated)]
    return not any(_is_simple(ratio / factor) for ratio in ratios for factor in factors)


def _tells(question: Question, other: Question) -> bool:
    """Return whether a question states a number that would be accepted as the answer to another."""
    moment = question.query.moment
    stated = moment.stated if moment is not None else ()
    return any(
        unit == other.unit and abs(number - other.answer) <= TOLERANCE * abs(other.answer) for number, unit in stated
    )


def _is_simple(ratio: float) -> bool:
    """Return whether a ratio is a fraction of small integers, possibly times π."""
    return any(
        abs(ratio * below / unit - round(ratio * below / unit)) <= TRIVIAL_RTOL * ratio * below / unit
        and 1 <= round(ratio * below / unit) <= MAX_NUMERATOR
        for unit in (1.0, pi)
        for below in range(1, MAX_NUMERATOR + 1)
    )
