"""Questions: a mode says what is unknown, a kind what is asked of the motion, a moment when.

A `Query` is what is asked, without words; a `Question` has words and an answer.
"""

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import ClassVar, TypeVar

import numpy as np

from sim2reason.base.registry import Registry
from sim2reason.questions.given import StatedResult
from sim2reason.questions.kinds import KINDS, Kind
from sim2reason.questions.moments import MOMENTS, Moment
from sim2reason.questions.query import Noun, Query, Target
from sim2reason.questions.regimes import Regime
from sim2reason.questions.study import Study
from sim2reason.questions.words import Words
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.text.prose.description import Description
from sim2reason.text.prose.symbol_names import with_names
from sim2reason.text.prose.voices import hiding


@dataclass(frozen=True, slots=True)
class Formula:
    """An answer as a formula: its LaTeX, the symbols that the problem has, and values that others must agree with.

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
        """The addresses of the numbers that the text must not tell: its unknown, and that whose limit is meant."""
        return tuple(path for path in dict.fromkeys((self.unknown, self.query.hides)) if path)

    @property
    def result(self) -> float:
        """The answer to its query: what is given where a number is unknown, else the answer itself."""
        return self.given.value if self.given is not None and self.unknown else self.answer


@dataclass(frozen=True, slots=True)
class ParsedQuestion:
    """What a sentence that was read asks: the query, and the answer to it that the sentence gives, if it does.

    `assumed` is what it says of the motion beforehand.
    """

    mode: str
    query: Query
    given: StatedResult | None = None
    assumed: tuple[Regime, ...] = ()


Suits = Callable[[Query, str, StatedResult | None], bool]
"""Whether a query may be asked, or the unknown number at an address for which it has a stated result."""


def anything(query: Query, unknown: str = "", stated: StatedResult | None = None) -> bool:
    """Return True for any query."""
    del query, unknown, stated
    return True


class QuestionMode(ABC):
    """What of a question is unknown. Filters ask a mode, not a kind, what its answer becomes in a changed scene.

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
        """Names of the kinds that the mode can ask; by default all but those for one of two, which need options."""
        return frozenset(name for name, kind in KINDS.items() if self.offers_options or not kind.names_one)

    def offers(self, mechanism: Mechanism) -> bool:
        """Return whether it may ask anything about a mechanism whose motion is not known yet; by default so."""
        del mechanism
        return True

    @abstractmethod
    def ask(
        self, study: Study, words: Words, kind: str, rng: np.random.Generator, suits: Suits = anything
    ) -> Question | None:
        """A question of a kind (by default drawn by share) about a motion that `suits`, or None if it offers none.

        What suits is looked at before an answer is worked out that costs much.
        """

    def asking(self, query: Query, study: Study, words: Words, rng: np.random.Generator) -> Question | None:
        """The question with a query that was found in another way; None, as by default, if this mode has none."""
        del query, study, words, rng
        return None

    def completed(self, question: Question, study: Study, words: Words, rng: np.random.Generator) -> Question | None:
        """A question that filters keep, with what costs too much to be found for others; None if there is no such.

        By default nothing is missing.
        """
        del study, words, rng
        return question

    def described(self, question: Question, description: Description) -> Description:
        """Return the text of the scene as a question needs it; by default with what it leaves open by its name."""
        left_open = question.left_open
        return with_names(description.voiced(hiding(*left_open))) if left_open else description

    @abstractmethod
    def parsed(self, text: str, study: Study, words: Words) -> ParsedQuestion | None:
        """Return what a sentence asks in this mode, found by trying every phrase; None if it is none of them."""

    def study(self, question: Question, study: Study) -> Study:
        """The motion that a question is about, where `study` is that of the scene as it was drawn; by default this."""
        del question
        return study

    def response(self, question: Question, study: Study, other: Study) -> float | None:
        """Return what the answer becomes if the motion is another's; None if what is asked about does not come.

        `study` is the one that the question is about. By default the query is asked again.
        """
        del study
        return KINDS[question.query.kind].answer(question.query, other)

    def solution(self, asked: ParsedQuestion, study: Study, words: Words) -> float | None:
        """The answer to what was read, in SI units or those of the text; None if there is none, or more than one."""
        del words
        return KINDS[asked.query.kind].answer(asked.query, study)

    def lacking(self, asked: ParsedQuestion, study: Study, words: Words) -> str:
        """Return a clause explaining why a parsed question has no answer, if nothing more specific is known."""
        del asked, study, words
        return "the scene has no such value"


MODES: Registry[QuestionMode] = Registry("modes", package="sim2reason.generation.modes")
M = TypeVar("M", bound=QuestionMode)


def mode(cls: type[M]) -> type[M]:
    """Enter a mode under its name."""
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
    "StatedResult",
    "Study",
    "Suits",
    "Target",
    "Words",
    "anything",
    "mode",
]
