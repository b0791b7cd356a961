"""Questions: their modes (what is unknown), kinds (what is asked of the motion) and moments (when).

A `Query` is what is asked, without words; a `Question` has words and an answer.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import ClassVar, TypeVar

import numpy as np

from sim2reason.base.registry import Registry
from sim2reason.questions.accuracy import StatedResult
from sim2reason.questions.kinds import KINDS, Kind
from sim2reason.questions.moments import MOMENTS, Moment
from sim2reason.questions.query import Noun, Query, Target
from sim2reason.questions.regimes import Regime
from sim2reason.questions.study import SimulatedScene
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.text.prose.description import Description, with_names
from sim2reason.text.prose.voices import symbolic_at


@dataclass(frozen=True, slots=True)
class Formula:
    """An answer as a formula, with its LaTeX, its symbols and numeric values for comparison.

    `units` are those in which a text gives the symbols; the `points` have radians for degrees and metres for
    kilometres, as formulas do. The first point is the scene's own, and `values` are the engine's answers at each.
    `within` are those symbols of bodies and of the question that stand in the formula, `without` those that don't.
    """

    latex: str
    symbols: tuple[str, ...]
    units: tuple[str, ...]
    points: tuple[tuple[float, ...], ...]
    values: tuple[float, ...]
    within: tuple[str, ...] = ()
    without: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Question:
    """A question in words with its answer.

    `sign` is the sense that counts as positive, in words; empty for a magnitude. `unknown` is the address of the number
    that the text must leave open, empty for none. Where the query's answer R is not what is asked for, `given` is what
    the question says that it is, and `elasticity` is d ln R/d ln p, p being the answer to the question. Where the
    numbers of the text are symbols, the answer is a `formula`, and `answer` its value in the scene; `assumed` is what
    it says of the motion.
    """

    mode: str
    query: Query
    text: str
    answer: float
    unit: str
    sign: str = ""
    unknown: str = ""
    given: StatedResult | None = None
    elasticity: float = 1.0
    formula: Formula | None = None
    assumed: tuple[Regime, ...] = ()

    @property
    def left_open(self) -> tuple[str, ...]:
        """Return the addresses of the numbers that the text must leave open, such as the unknown."""
        return tuple(path for path in dict.fromkeys((self.unknown, self.query.hides)) if path)

    @property
    def result(self) -> float:
        """Return the answer to the query: the given result if a number is unknown, else the question's answer."""
        return self.given.value if self.given is not None and self.unknown else self.answer


@dataclass(frozen=True, slots=True)
class ParsedQuestion:
    """The meaning of a parsed sentence: its query and, if the sentence states one, the given result.

    `assumed` are its assumptions about the motion.
    """

    mode: str
    query: Query
    given: StatedResult | None = None
    assumed: tuple[Regime, ...] = ()


Suits = Callable[[Query, str, StatedResult | None], bool]
"""Whether a query may be asked, or the unknown number at an address for which it has a stated result."""


def accepts_any_query(query: Query, unknown: str = "", stated: StatedResult | None = None) -> bool:
    """Return True for any query."""
    del query, unknown, stated
    return True


class QuestionMode(ABC):
    """The base class of modes, which define what is unknown in a question and how its answer changes with the scene.

    Class data:
        name: under which it is registered.
        several: whether an item asks several questions about one scene, each of which leads to another.
        offers_options: whether an item comes with options, one of which is its answer.
        weights: by which factor some kinds of question are asked more or less often than in other modes.
    """

    name: ClassVar[str]
    several: ClassVar[bool] = False
    offers_options: ClassVar[bool] = False
    weights: ClassVar[Mapping[str, float]] = {}

    @property
    def kinds(self) -> frozenset[str]:
        """Return the names of the kinds that the mode can ask; by default all kinds that need no options."""
        return frozenset(name for name, kind in KINDS.items() if self.offers_options or not kind.names_one)

    def offers(self, mechanism: Mechanism) -> bool:
        """Return whether the mode may ask anything about a mechanism, judged without its motion; by default True."""
        del mechanism
        return True

    @abstractmethod
    def ask(
        self, study: SimulatedScene, words: Words, kind: str, rng: np.random.Generator, suits: Suits = accepts_any_query
    ) -> Question | None:
        """Return a question about a motion that passes the predicate `suits`; None if the mode finds none.

        The predicate is tested before costly computations of an answer.
        """

    def asking(self, query: Query, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Question | None:
        """Return the question for a given query; None, as by default, if the mode has no such question."""
        del query, study, words, rng
        return None

    def completed(
        self, question: Question, study: SimulatedScene, words: Words, rng: np.random.Generator
    ) -> Question | None:
        """Return a question with the costly parts of its answer added; None if these do not exist.

        By default nothing is missing.
        """
        del study, words, rng
        return question

    def described(self, question: Question, description: Description) -> Description:
        """Return the text of the scene for a question; by default with symbols for the numbers that it leaves open."""
        left_open = question.left_open
        return with_names(description.voiced(symbolic_at(*left_open))) if left_open else description

    @abstractmethod
    def parsed(self, text: str, study: SimulatedScene, words: Words) -> ParsedQuestion | None:
        """Return the question of this mode that a sentence expresses; None if no phrase of the mode matches."""

    def study(self, question: Question, study: SimulatedScene) -> SimulatedScene:
        """Return the motion that a question is about; by default `study`, the motion of the scene as drawn."""
        del question
        return study

    def response(self, question: Question, study: SimulatedScene, other: SimulatedScene) -> float | None:
        """Return the answer to a question in another motion; None if the answer does not exist there.

        `study` is the one that the question is about. By default the query is asked again.
        """
        del study
        return KINDS[question.query.kind].answer(question.query, other)

    def solution(self, asked: ParsedQuestion, study: SimulatedScene, words: Words) -> float | None:
        """Return the answer to a parsed question, in SI units or those of the text; None unless it is unique."""
        del words
        return KINDS[asked.query.kind].answer(asked.query, study)

    def lacking(self, asked: ParsedQuestion, study: SimulatedScene, words: Words) -> str:
        """Return a clause explaining why a parsed question has no answer, used if no more specific reason is known."""
        del asked, study, words
        return "the scene has no such value"


MODES: Registry[QuestionMode] = Registry("modes", package="sim2reason.generation.modes")
M = TypeVar("M", bound=QuestionMode)


def mode(cls: type[M]) -> type[M]:
    """Register a mode under its name."""
    MODES.add(cls.name, cls())
    return cls


__all__ = [
    "KINDS",
    "MODES",
    "MOMENTS",
    "Formula",
    "Kind",
    "Moment",
    "Noun",
    "ParsedQuestion",
    "Query",
    "Question",
    "QuestionMode",
    "SimulatedScene",
    "StatedResult",
    "Suits",
    "Target",
    "Words",
    "accepts_any_query",
    "mode",
]
