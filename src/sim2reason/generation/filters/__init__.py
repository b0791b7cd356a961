"""Filters: each rejects questions for one reason, counted in the manifest of a dataset."""

from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import lru_cache
from math import inf, isfinite
from typing import ClassVar, Self

from sim2reason.base.records import cached_property
from sim2reason.base.registry import Registry
from sim2reason.questions import KINDS, MODES, Kind, Query, Question, SimulatedScene, Words
from sim2reason.questions.accuracy import TOLERANCE
from sim2reason.questions.difficulty import EVERY, Difficulty, Need
from sim2reason.questions.study import TIME_MARGIN
from sim2reason.simulation.certify import Certificate
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.solutions import Solution
from sim2reason.solutions.derivation import (
    derivation,
    is_derived,
    is_solved,
    shortest_solution,
    shortest_verified_solution,
)
from sim2reason.solutions.difficulty import SolutionDifficulty, measure_difficulty, number_of_events


@dataclass(frozen=True)
class Candidate:
    """A question that may become an item, with its scene, motion and text."""

    study: SimulatedScene
    question: Question
    prompt: str
    sentences: tuple[str, ...] = ()  # of the scene's text
    words: Words | None = None  # in which the question is asked
    certificate: Certificate | None = None  # once the witness has been heard
    difficulty: Difficulty = "medium"
    tolerance: float = TOLERANCE
    needs: frozenset[Need] = EVERY
    """What its solution may need."""
    labelled: bool = False
    """Whether its difficulty was ordered, and must fit."""
    easy: bool = False
    """Whether questions that few laws or one line answer are kept."""
    beside: "tuple[Candidate, ...]" = ()
    """Earlier parts of the same problem."""

    @property
    def kind(self) -> Kind:
        """Return the question kind."""
        return KINDS[self.question.query.kind]

    @cached_property
    def time(self) -> float | None:
        """Return the latest time of the motion on which the answer depends, s; None if the whole motion matters."""
        return self.kind.time(self.question.query, self.study)

    @cached_property
    def solution(self) -> Solution | None:
        """Return the shortest worked solution with allowed mathematics and no integration; None without a text."""
        if self.words is None:
            return None
        question = self.question
        if question.formula is not None:
            return derivation(question.query, self.study, self.words)
        return shortest_solution(
            question.query, self.study, self.words, question.unknown, question.given, max(self.needs)
        )

    @property
    def checked(self) -> Self:
        """Return the candidate, with another worked solution if the independent checker rejects the first one."""
        question, solution = self.question, self.solution
        if self.words is None or question.formula is not None or solution is None or solution.answer is None:
            return self
        arguments = question.query, self.study, self.words, question.unknown, question.given, max(self.needs)
        other = shortest_verified_solution(*arguments)
        return self if other is solution else replace(self)

    @property
    def is_solved(self) -> bool:
        """Return whether `solution` is cached, so that reading it is cheap."""
        question = self.question
        if question.formula is not None:
            return is_derived(question.query, self.study)
        return is_solved(question.query, self.study, question.unknown, question.given, max(self.needs))

    @cached_property
    def measured(self) -> SolutionDifficulty | None:
        """Return the difficulty of the shortest solution with those of earlier parts; None without a solution."""
        solutions = self.solved
        return (
            measure_difficulty(*solutions, *(part for each in self.beside for part in each.solved))
            if solutions
            else None
        )

    @property
    def solved(self) -> tuple[tuple[Solution, int], ...]:
        """Return the pair of the worked solution and its number of events, as a tuple; empty without a solution."""
        if self.solution is None or self.solution.answer is None:
            return ()
        return ((self.solution, number_of_events(self.study.trace, self.time)),)

    @property
    def until(self) -> float | None:
        """Return the time up to which scenes with changed numbers are simulated, s; None for the usual duration."""
        return None if self.time is None else TIME_MARGIN * self.time

    @cached_property
    def _responses(self) -> dict[SimulatedScene, float | None]:
        """Return the cache of answers to the question in changed scenes; filters and the symbolic mode share it."""
        question = replace(self.question, text="", formula=None, assumed=())
        return self.study.memoize(("responses", question), dict[SimulatedScene, float | None])

    def response(self, other: SimulatedScene | None) -> float | None:
        """Return the answer to the same question in a changed scene; None if it has none."""
        if other is None:
            return None
        if other not in self._responses:
            self._responses[other] = self._answered(other)
        return self._responses[other]

    def _answered(self, other: SimulatedScene) -> float | None:
        if not _has(other, self.question.query):
            return None
        time = self.kind.time(self.question.query, other)
        if time is None or time > other.trace.stable_until:
            return None
        answer = MODES[self.question.mode].response(self.question, self.study, other)
        return answer if answer is not None and isfinite(answer) else None

    def far_response(self, other: SimulatedScene | None) -> float | None:
        """Return the answer in a changed scene whose motion may last longer; as `response` for a given result."""
        if other is None or self.question.given is not None or not _has(other, self.question.query):
            return self.response(other)
        time = self.kind.time(self.question.query, other)
        if time is None or time > other.trace.stable_until:
            return None
        answer = self.kind.far_answer(self.question.query, other)
        return answer if answer is not None and isfinite(answer) else None

    def change(self, other: SimulatedScene | None) -> float:
        """Return the relative difference of the answer in a changed scene; infinite if there is no answer."""
        return self.change_to(self.response(other))

    def change_to(self, answer: float | None) -> float:
        """Return the relative difference between the answer and another value; infinite for None."""
        return inf if answer is None else abs(answer / self.question.answer - 1.0)


def _has(study: SimulatedScene, query: Query) -> bool:
    """Return whether a changed scene still contains the subject, quantity and moment of a query."""
    mechanism, target = study.mechanism, query.target
    if query.moment is not None and not query.moment.possible(mechanism):
        return False
    return target is None or target.subject in QUANTITIES[target.quantity].subjects(mechanism)


@dataclass(frozen=True, slots=True)
class Verdict:
    """The decision of a filter: whether it keeps a question and, if not, the reason."""

    keep: bool
    filter: str
    reason: str = ""

    @property
    def manifest_name(self) -> str:
        """Return the name under which a manifest counts the verdict: the filter's, with the cause if given."""
        cause, colon, _ = self.reason.partition(": ")
        return f"{self.filter}: {cause}" if colon else self.filter


class Filter(ABC):
    """The base class of filters: one reason to reject a question.

    Class data:
        order: its place among the filters: what costs little comes first.
        needs_witness: whether it runs last, with the certificate, since the witness costs most.
    """

    order: ClassVar[int]
    needs_witness: ClassVar[bool] = False

    def ready(self, candidate: Candidate) -> bool:
        """Return whether all that the filter needs is already computed, so that it can run first."""
        del candidate
        return False

    @abstractmethod
    def reason(self, candidate: Candidate) -> str:
        """Return the reason to reject the question, in a few words; empty to keep it.

        If a manifest should count several causes separately, the cause comes first, before a colon.
        """

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """Yield the measured values behind the decision as report lines; by default only the reason."""
        del candidate
        yield from ()


class SceneFilter(Filter):
    """The base class of filters that reject a scene before any question about it."""

    order = 0

    @abstractmethod
    def scene_reason(self, study: SimulatedScene) -> str:
        """Return the reason to reject the scene, in a few words; empty to keep it."""

    def reason(self, candidate: Candidate) -> str:
        """Return the reason to reject the scene of the question."""
        return self.scene_reason(candidate.study)


FILTERS: Registry[Filter] = Registry("filters", package="sim2reason.generation.filters")


def filter_scene(study: SimulatedScene) -> Verdict:
    """Return the verdict on a scene: the first rejection, if there is one."""
    for name, filter_ in ordered_filters():
        if isinstance(filter_, SceneFilter) and (reason := filter_.scene_reason(study)):
            return Verdict(keep=False, filter=name, reason=reason)
    return Verdict(keep=True, filter="")


def apply_filters(candidate: Candidate, *, witnessed: bool) -> Verdict:
    """Return the verdict of all filters that need both engines (`witnessed`), or of all others: the first rejection."""
    filters = [each for each in ordered_filters() if each[1].needs_witness == witnessed]
    for name, filter_ in sorted(filters, key=lambda each: not each[1].ready(candidate)):
        if reason := filter_.reason(candidate):
            return Verdict(keep=False, filter=name, reason=reason)
    return Verdict(keep=True, filter="")


def ordered_filters() -> tuple[tuple[str, Filter], ...]:
    """Return all filters with their names, in the order in which they run."""
    return _ordered(tuple(FILTERS.items()))


@lru_cache(maxsize=4)  # the registry may grow
def _ordered(filters: tuple[tuple[str, Filter], ...]) -> tuple[tuple[str, Filter], ...]:
    return tuple(sorted(filters, key=lambda item: (item[1].needs_witness, item[1].order, item[0])))
