"""Check of questions about an entity."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from sim2reason.questions import KINDS
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.sentences import parse_question
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens

MIN_KINDS = 2  # question kinds
TRIES = 4


@check
class QuestionsCheck(Check):
    """Check that at least two kinds of questions can be asked, and each sentence parses back to its question."""

    name = "questions"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Ask a question of every kind about every scene."""
        asked = set[str]()
        for found in specimens.moving:
            for kind in KINDS:
                for number in range(TRIES):
                    yield from self._ask(found, kind, number, asked)
        if len(asked) < MIN_KINDS:
            names = ", ".join(sorted(asked)) or "none"
            expected = f"questions of at least {MIN_KINDS} kinds can be asked"
            remedy = "name bodies in build as their fields are, `room.body('bob', …)` for `bob`, and let something move"
            yield Finding(self.name, expected, f"there is only: {names}", remedy)

    def _ask(self, found: Specimen, name: str, number: int, asked: set[str]) -> Iterator[Finding]:
        study, words, targets, kind = found.study, found.words, found.targets, KINDS[name]
        query = kind.draw(study, words, targets, np.random.default_rng([found.seed, number]))
        answer = kind.answer(query, study) if query is not None else None
        if query is None or answer is None or not np.isfinite(answer):
            return
        asked.add(name)
        noun = targets[query.target] if query.target is not None else None
        hidden = tuple(unknown for unknown in words.unknowns if unknown.path == query.hides)
        told = replace(words, unknowns=hidden)  # a text leaves no more unknown than is asked for
        for shape in kind.shapes(query, words, noun):
            text = sentence(shape)
            if parse_question(text, study, told) != query:
                expected = "a question in words leads back to what it asks"
                remedy = "call bodies by names that can be told apart"
                yield found.finding(self.name, expected, f"{text!r} does not lead back to {query}", remedy)
                return
