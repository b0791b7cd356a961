"""Numeric modes: numeric, multiple choice, and multi-part."""

from collections.abc import Mapping
from itertools import takewhile
from typing import ClassVar

import numpy as np

from sim2reason.questions import (
    KINDS,
    Kind,
    ParsedQuestion,
    Query,
    Question,
    QuestionMode,
    SimulatedScene,
    Suits,
    Words,
    accepts_any_query,
    mode,
)
from sim2reason.questions.kinds import kinds_by_share
from sim2reason.questions.phrasing import draw_sentence, sentence
from sim2reason.questions.query import targets
from sim2reason.questions.sentences import parse_question

MAX_DRAWS = 3  # queries of one kind, at most, until one is suitable


@mode
class Numeric(QuestionMode):
    """Question for a number that follows from the stated numbers."""

    name = "numeric"
    weights: ClassVar[Mapping[str, float]] = {"limit": 0.1}  # few limits hang on numbers that no simpler question has

    def ask(
        self, study: SimulatedScene, words: Words, kind: str, rng: np.random.Generator, suits: Suits = accepts_any_query
    ) -> Question | None:
        """Return a random suitable question of a kind with a finite answer, or None."""
        questions = (
            self._ask_query(question_kind, study, words, rng, suits)
            for question_kind in ([KINDS[kind]] if kind else kinds_by_share(rng))
        )
        return next((question for question in questions if question is not None), None)

    def _ask_query(
        self, asked: Kind, study: SimulatedScene, words: Words, rng: np.random.Generator, suits: Suits
    ) -> Question | None:
        offered = targets(words)
        drawn = (asked.draw(study, words, offered, rng) for _ in range(1 if asked.costly else MAX_DRAWS))
        queries = takewhile(lambda query: query is not None, drawn)
        query = next((query for query in queries if query is not None and suits(query, "", None)), None)
        return self.asking(query, study, words, rng) if query is not None else None

    def asking(self, query: Query, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Question | None:
        """Return the question for a query, with its answer; None if the answer is not finite."""
        kind, offered = KINDS[query.kind], targets(words)
        answer = kind.answer(query, study)
        if answer is None or not np.isfinite(answer):
            return None
        target = query.target
        shapes = kind.shapes(query, words, offered[target] if target is not None else None)
        sign = target.sense.positive if target is not None and target.sense is not None else ""
        unit = words.units.spell(kind.measured(query).unit)
        return Question(self.name, query, sentence(draw_sentence(shapes, rng)), answer, unit, sign, query.hides)

    def parsed(self, text: str, study: SimulatedScene, words: Words) -> ParsedQuestion | None:
        """Parse a query in the words of its kind; a number that the text leaves unknown must be its target."""
        query = parse_question(text, study, words, self.kinds) if not words.symbolic else None
        hidden = {unknown.path for unknown in words.unknowns}
        return ParsedQuestion(self.name, query) if query is not None and hidden <= {query.hides} else None


@mode
class Choice(Numeric):
    """Question for the correct one of several numbers."""

    name = "choice"
    offers_options = True

    def parsed(self, text: str, study: SimulatedScene, words: Words) -> ParsedQuestion | None:
        """Parse a question that asks which of two candidates is first or greater; return None for any other."""
        own = [name for name, kind in KINDS.items() if kind.names_one]
        query = parse_question(text, study, words, own) if not words.symbolic else None
        return ParsedQuestion(self.name, query) if query is not None else None


@mode
class Multipart(Numeric):
    """Several numeric questions, of which earlier ones help with later ones.

    Each part is a numeric question; `datasets.part_search` looks for those that build on each other.
    """

    name = "multipart"
    several = True

    @property
    def kinds(self) -> frozenset[str]:
        """Return the question kinds whose questions leave no stated number unknown, since other parts may need it."""
        return frozenset(name for name in super().kinds if not KINDS[name].hides)

    def asking(self, query: Query, study: SimulatedScene, words: Words, rng: np.random.Generator) -> Question | None:
        """Return the question for a query; None also if its unknown is a number that other parts may need."""
        return super().asking(query, study, words, rng) if not query.hides else None

    def parsed(self, text: str, study: SimulatedScene, words: Words) -> ParsedQuestion | None:
        """Return None: each part is parsed by itself, as a numeric question."""
        del text, study, words
        return None
