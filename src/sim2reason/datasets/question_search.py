"""Ask about one scene until a question passes every filter."""

from collections import Counter
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from sim2reason.dsl.scene import Scene
from sim2reason.filters import Candidate, sift
from sim2reason.prose.writer import Description, describe
from sim2reason.questions import KINDS, Mode, Query, Question, Study, Words
from sim2reason.questions.prompt import shaped, words_of
from sim2reason.questions.study import BEYOND
from sim2reason.recipes import Difficulty
from sim2reason.simulation.certify import Certificate, witnessed

SAMPLES = 41
SHORTEST = 0.05  # of the horizon: a motion that may be used for less is of no use
QUESTIONS = 4  # tries


@dataclass(frozen=True)
class CertifiedQuestion:
    """A question that passed, with its text and what vouches for its answer."""

    candidate: Candidate
    study: Study  # its motion is recorded beyond what is asked, and cut where the engines part
    certificate: Certificate
    description: Description
    shape: str  # of the prompt

    @property
    def question(self) -> Question:
        """The question with its answer."""
        return self.candidate.question

    @property
    def prompt(self) -> str:
        """The whole text."""
        return self.candidate.prompt


class QuestionSearch:
    """A scene with its motion and its text, which all questions about it share.

    Raises:
        SceneError, UnsupportedError, SimulationError: the scene can not be built, modelled or solved.
    """

    def __init__(self, scene: Scene, wording: int, difficulty: Difficulty = "medium") -> None:
        """`wording` is the seed of the text."""
        self._difficulty: Difficulty = difficulty
        self.study = Study.of(scene, np.linspace(0.0, scene.horizon, SAMPLES))
        self._wording = wording
        self._vouched: tuple[Study, Certificate] | None = None

    @cached_property
    def description(self) -> Description:
        """Its text."""
        return describe(self.study.scene, self._wording)

    @cached_property
    def words(self) -> Words:
        """What questions need to know of its text."""
        return words_of(self.description)

    def _certified(self, query: Query) -> tuple[Study, Certificate]:
        """The motion as far as both engines vouch for it; the second follows it no further than a question needs."""
        time = KINDS[query.kind].time(query, self.study)
        trace = self.study.trace if time is None else self.study.trace.through(BEYOND * time)
        if self._vouched is None or len(self._vouched[0].trace.state.times) < len(trace.state.times):
            seen, certificate = witnessed(trace)
            self._vouched = Study(self.study.scene, seen), certificate
        return self._vouched

    def ask(
        self, mode: Mode, rng: np.random.Generator, refused: Counter[str], kind: str = ""
    ) -> CertifiedQuestion | None:
        """A question that passes every filter, or None; what was refused is counted by filter in `refused`."""
        if self.study.trace.stable_until < SHORTEST * self.study.scene.horizon:
            refused[f"unstable: {self.study.trace.cut}"] += 1
            return None
        description, words = self.description, self.words
        for _ in range(QUESTIONS):
            question = mode(self.study, words, kind, rng)
            if question is None:
                refused["nothing to ask"] += 1
                continue
            prompt = shaped(description, question, rng)
            candidate = Candidate(self.study, question, prompt.text, description.sentences, difficulty=self._difficulty)
            verdict = sift(candidate, witnessed=False)
            if verdict.keep:
                study, certificate = self._certified(question.query)
                verdict = sift(replace(candidate, certificate=certificate), witnessed=True)
                if verdict.keep:
                    return CertifiedQuestion(candidate, study, certificate, description, prompt.shape)
            refused[verdict.counted] += 1
        return None
