"""Filters: each drops questions for one reason, which the manifest of a dataset counts."""

from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import inf, isfinite
from typing import ClassVar, Self

from sim2reason.base.lazy import cached_property
from sim2reason.base.registry import Registry
from sim2reason.questions import KINDS, MODES, Kind, Query, Question, Study, Words
from sim2reason.questions.difficulty import Difficulty
from sim2reason.questions.need import EVERY, Need
from sim2reason.questions.study import BEYOND
from sim2reason.questions.tolerance import TOLERANCE
from sim2reason.simulation.certify import Certificate
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.solutions import Solution
from sim2reason.solutions.derivation import derivation, is_derived
from sim2reason.solutions.difficulty import SolutionDifficulty, measured, number_of_events
from sim2reason.solutions.shortest import is_solved, shortest, shortest_checked


@dataclass(frozen=True)
class Candidate:
    """A question that may become an item, with what it was asked about."""

    study: Study
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
        """The kind of the question."""
        return KINDS[self.question.query.kind]

    @cached_property
    def time(self) -> float | None:
        """Return when all that the answer depends on has happened, s."""
        return self.kind.time(self.question.query, self.study)

    @cached_property
    def solution(self) -> Solution | None:
        """Its shortest solution that needs no more than it may, and no integration; None without words."""
        if self.words is None:
            return None
        question = self.question
        if question.formula is not None:
            return derivation(question.query, self.study, self.words)
        return shortest(question.query, self.study, self.words, question.unknown, question.given, max(self.needs))

    @property
    def checked(self) -> Self:
        """Return the candidate itself if its solution was verified, otherwise one with a solution that was."""
        question, found = self.question, self.solution
        if self.words is None or question.formula is not None or found is None or found.answer is None:
            return self
        asked = question.query, self.study, self.words, question.unknown, question.given, max(self.needs)
        other = shortest_checked(*asked)
        return self if other is found else replace(self)

    @property
    def is_solved(self) -> bool:
        """Return whether `solution` is cached, so that reading it is cheap."""
        question = self.question
        if question.formula is not None:
            return is_derived(question.query, self.study)
        return is_solved(question.query, self.study, question.unknown, question.given, max(self.needs))

    @cached_property
    def measured(self) -> SolutionDifficulty | None:
        """Difficulty of the shortest solution together with those of earlier parts; None without a solution."""
        held = self.solved
        return measured(*held, *(part for each in self.beside for part in each.solved)) if held else None

    @property
    def solved(self) -> tuple[tuple[Solution, int], ...]:
        """Return that solution with the number of events before what is asked about; nothing where there is none."""
        if self.solution is None or self.solution.answer is None:
            return ()
        return ((self.solution, number_of_events(self.study.trace, self.time)),)

    @property
    def until(self) -> float | None:
        """Return how far motions of scenes like this one are followed, s."""
        return None if self.time is None else BEYOND * self.time

    @cached_property
    def _responses(self) -> dict[Study, float | None]:
        """Return what was answered before: several filters ask about the same changed scenes, and again in symbols."""
        asked = replace(self.question, text="", formula=None, assumed=())
        return self.study.once(("responses", asked), dict[Study, float | None])

    def response(self, other: Study | None) -> float | None:
        """Return the answer to the same question about a changed scene; None if it has none there."""
        if other is None:
            return None
        if other not in self._responses:
            self._responses[other] = self._answered(other)
        return self._responses[other]

    def _answered(self, other: Study) -> float | None:
        if not _has(other, self.question.query):
            return None
        time = self.kind.time(self.question.query, other)
        if time is None or time > other.trace.stable_until:
            return None
        found = MODES[self.question.mode].response(self.question, self.study, other)
        return found if found is not None and isfinite(found) else None

    def far_response(self, other: Study | None) -> float | None:
        """Return the same, looked for as far as it takes, where no result is given."""
        if other is None or self.question.given is not None or not _has(other, self.question.query):
            return self.response(other)
        time = self.kind.time(self.question.query, other)
        if time is None or time > other.trace.stable_until:
            return None
        found = self.kind.far_answer(self.question.query, other)
        return found if found is not None and isfinite(found) else None

    def change(self, other: Study | None) -> float:
        """Return the relative change of the answer in a changed scene; infinite if it has none there."""
        return self.change_to(self.response(other))

    def change_to(self, answer: float | None) -> float:
        """Return the relative change of the answer to another one; infinite to none."""
        return inf if answer is None else abs(answer / self.question.answer - 1.0)


def _has(study: Study, query: Query) -> bool:
    """Tell whether a changed scene still has what a query speaks of; what is held has no normal force of its own."""
    mechanism, target = study.mechanism, query.target
    if query.moment is not None and not query.moment.possible(mechanism):
        return False
    return target is None or target.subject in QUANTITIES[target.quantity].subjects(mechanism)


@dataclass(frozen=True, slots=True)
class Verdict:
    """Whether a filter keeps a question, and if not, why."""

    keep: bool
    filter: str
    reason: str = ""

    @property
    def counted(self) -> str:
        """Under which name a manifest counts it: the filter's, and the cause if the reason names one."""
        cause, colon, _ = self.reason.partition(": ")
        return f"{self.filter}: {cause}" if colon else self.filter


class Filter(ABC):
    """One reason to drop a question.

    Class data:
        order: its place among the filters: what costs little comes first.
        needs_witness: whether it runs last, with the certificate, since the witness costs most.
    """

    order: ClassVar[int]
    needs_witness: ClassVar[bool] = False

    def ready(self, candidate: Candidate) -> bool:
        """Return whether all that it looks at is worked out, so that it may as well come first; by default not."""
        del candidate
        return False

    @abstractmethod
    def reason(self, candidate: Candidate) -> str:
        """Return why the question must go, in a few words; empty if it may stay.

        Where a manifest should count several causes apart, the cause stands first, before a colon.
        """

    def findings(self, candidate: Candidate) -> Iterator[str]:
        """What it finds on the way, line by line, for whoever wants to know; by default no more than its reason."""
        del candidate
        yield from ()


class SceneFilter(Filter):
    """One reason to drop a scene, and with it all questions about it; scenes are filtered before anything is asked."""

    order = 0

    @abstractmethod
    def scene_reason(self, study: Study) -> str:
        """Return why the scene must go, in the form of `Filter.reason`; empty if it may stay."""

    def reason(self, candidate: Candidate) -> str:
        """Return the reason against the scene."""
        return self.scene_reason(candidate.study)


FILTERS: Registry[Filter] = Registry("filters", package="sim2reason.generation.filters")


def sift_scene(study: Study) -> Verdict:
    """Return the first verdict against a scene."""
    for name, found in in_order():
        if isinstance(found, SceneFilter) and (reason := found.scene_reason(study)):
            return Verdict(keep=False, filter=name, reason=reason)
    return Verdict(keep=True, filter="")


def sift(candidate: Candidate, *, witnessed: bool) -> Verdict:
    """Return the first verdict against a question among the filters that need a witness, or that need none."""
    filters = [(name, found) for name, found in in_order() if found.needs_witness == witnessed]
    for name, found in sorted(filters, key=lambda each: not each[1].ready(candidate)):
        if reason := found.reason(candidate):
            return Verdict(keep=False, filter=name, reason=reason)
    return Verdict(keep=True, filter="")


def in_order() -> list[tuple[str, Filter]]:
    """Return all filters with their names, in the order in which they run."""
    return sorted(FILTERS.items(), key=lambda item: (item[1].needs_witness, item[1].order, item[0]))
