"""Checks of questions about an entity and of their worked solutions."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np

from sim2reason.errors import Sim2ReasonError
from sim2reason.questions import KINDS
from sim2reason.questions.phrasing import sentence
from sim2reason.questions.sentences import parse_question
from sim2reason.scenes.dsl.mechanism import Mechanism
from sim2reason.scenes.dsl.structure import changing
from sim2reason.solutions import ProblemContext, solve
from sim2reason.testing.checks import Check, check
from sim2reason.testing.report import Finding
from sim2reason.testing.specimens import Specimen, Specimens

MIN_KINDS = 2  # question kinds
MAX_QUESTION_DRAWS = 4


@check
class QuestionsCheck(Check):
    """Check that at least two kinds of questions can be asked, and each sentence parses back to its question."""

    name = "questions"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Ask a question of every kind about every scene."""
        asked_kinds = set[str]()
        for specimen in specimens.moving:
            for kind in KINDS:
                for number in range(MAX_QUESTION_DRAWS):
                    yield from self._ask(specimen, kind, number, asked_kinds)
        if len(asked_kinds) < MIN_KINDS:
            names = ", ".join(sorted(asked_kinds)) or "none"
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
        question_words = replace(words, unknowns=hidden)  # a text leaves no more unknown than is asked for
        for shape in kind.shapes(query, words, noun):
            text = sentence(shape)
            if parse_question(text, study, question_words) != query:
                expected = "a question in words leads back to what it asks"
                remedy = "call bodies by names that can be told apart"
                yield found.finding(self.name, expected, f"{text!r} does not lead back to {query}", remedy)
                return


MAX_SOLUTION_DRAWS = 3  # questions about one scene


@check
class SolutionsCheck(Check):
    """Check that some question about an entity with constant forces has a worked solution in formulas."""

    name = "solutions"

    def findings(self, specimens: Specimens) -> Iterator[Finding]:
        """Yield a finding if no question about scenes with constant forces has a worked solution."""
        steady = [specimen for specimen in specimens.moving if _is_pushed(specimen.scene.mechanism)]
        reasons = [reason for specimen in steady for reason in _reasons(specimen)]
        if steady and reasons and "" not in reasons:
            yield steady[0].finding(
                self.name,
                "constant forces lead to worked solutions by formulas",
                f"none of {len(reasons)} questions has one, such as: {reasons[0]}",
                "let build take numbers that lines tell, sines and cosines of angles among them, and products of these",
            )


def _is_pushed(mechanism: Mechanism) -> bool:
    """Return whether only constant forces act, among them some not due to strings, springs or faces."""
    return bool(mechanism.forces) and not changing(mechanism)


def _reasons(specimen: Specimen) -> Iterator[str]:
    """Yield the reason why each question drawn about a scene has no worked solution; empty if the question has one."""
    kind = KINDS["state"]
    for number in range(MAX_SOLUTION_DRAWS):
        query = kind.draw(
            specimen.study, specimen.words, specimen.targets, np.random.default_rng([specimen.seed, number])
        )
        answer = kind.answer(query, specimen.study) if query is not None else None
        if query is None or not answer:
            continue
        setting = ProblemContext(specimen.scene, specimen.words, specimen.description.symbols, specimen.study, query)
        try:
            yield solve(setting, derived=True).reason
        except Sim2ReasonError as error:
            yield str(error)
