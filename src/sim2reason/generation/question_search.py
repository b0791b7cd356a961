"""Search for a question about one scene that passes every filter."""

from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain

import numpy as np

from sim2reason.base.records import cached_property
from sim2reason.generation.certified import CertifiedQuestion
from sim2reason.generation.filters import FILTERS, Candidate, Verdict, apply_filters, filter_scene
from sim2reason.generation.filters.texts import is_followable
from sim2reason.questions import KINDS, Query, Question, QuestionMode, SimulatedScene, StatedResult, Words
from sim2reason.questions.accuracy import TOLERANCE
from sim2reason.questions.difficulty import EVERY, Difficulty, Need
from sim2reason.questions.prompt import shaped, words_of
from sim2reason.questions.sentences import irrelevant
from sim2reason.questions.study import TIME_MARGIN
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.dsl.structure import changing
from sim2reason.scenes.dsl.template import Topic
from sim2reason.simulation.certify import Certificate, certify_trace
from sim2reason.solutions.derivation import may_have_solution, shortest_solution
from sim2reason.text.prose.description import Description, describe

SAMPLE_COUNT = 41
MIN_CERTIFIED_FRACTION = 0.05  # of the horizon: shortest certified part of a motion
MAX_WORDINGS = 6  # tries
MAX_QUESTIONS = 4  # different tries
DRAWS, MISSES = 8, 2  # questions drawn, and failed draws in a row, at most
DRAW_FACTOR = 8  # factor on the draws if only some quantities are allowed
SETTINGS = SAMPLE_COUNT, MIN_CERTIFIED_FRACTION, MAX_WORDINGS, MAX_QUESTIONS, DRAWS, MISSES, DRAW_FACTOR
NOTHING, INCOMPLETE = "nothing to ask", "incomplete"  # causes as counted in a manifest
UNSUITED = "needs: before an answer"  # cause as counted in a manifest


@dataclass(frozen=True)
class RefusedQuestion:
    """A question that a filter refused, with the candidate as the filter examined it."""

    candidate: Candidate
    verdict: Verdict

    @property
    def findings(self) -> tuple[str, ...]:
        """Numbers that the filter compared, line by line; empty for a filter that compares none."""
        filter_ = FILTERS.get(self.verdict.filter)
        return () if filter_ is None else tuple(filter_.findings(self.candidate))


@dataclass(frozen=True)
class _WordedQuestion:
    """A question with its candidate for the filters and the text that states it."""

    candidate: Candidate
    description: Description
    shape: str


def _kept(candidate: Candidate, *, witnessed: bool) -> Verdict:
    """Return a verdict that keeps every question, in place of the filters when they are off."""
    del candidate, witnessed
    return Verdict(keep=True, filter="")


class QuestionSearch:
    """A scene with its motion and text, shared by all questions about it.

    Raises:
        SceneError, UnsupportedError, SimulationError: the scene can not be built, modelled or solved.
    """

    def __init__(
        self,
        scene: Scene | SimulatedScene,
        wording: int,
        difficulty: Difficulty | None = None,
        *,
        unfiltered: bool = False,
        quantities: frozenset[str] = frozenset(),
        tolerance: float = TOLERANCE,
        needs: frozenset[Need] = EVERY,
    ) -> None:
        """Prepare a search; `wording` seeds the text, and empty `quantities` allow all quantities.

        `needs` are the needs that solutions may have; questions with other needs are refused before their answers are
        computed. With a `difficulty`, questions of other difficulties are refused. A scene is followed to its horizon;
        a study already has a motion.
        """
        self._difficulty: Difficulty | None = difficulty
        self._quantities, self._tolerance, self._needs = quantities, tolerance, needs
        self.easy = False  # whether what few laws or one line answer is kept
        self._unfiltered, self._sift = unfiltered, _kept if unfiltered else apply_filters
        self.study = (
            scene
            if isinstance(scene, SimulatedScene)
            else SimulatedScene.of(scene, np.linspace(0.0, scene.horizon, SAMPLE_COUNT))
        )
        self._first_wording = wording
        self._certified_motion: tuple[SimulatedScene, Certificate] | None = None
        self._texts: dict[frozenset[Topic], Description] = {}  # by the topics that they leave out
        self.kinds: set[str] = set()  # of questions that were found in it
        self.beyond: set[str] = set()  # of those of which all that was drawn needs other means
        self._refused = False  # for what it needs, what was drawn last
        self.on_refusal: Callable[[RefusedQuestion], None] | None = None  # called with each question that is refused

    def release(self) -> None:
        """Discard what is cached about the motion, when no more questions are asked about it."""
        self.study.release()
        if self._certified_motion is not None:
            self._certified_motion[0].release()

    @cached_property
    def description(self) -> Description:
        """Return the text of the scene, in a wording with short sentences about strings if one of a few has them."""
        first = describe(self.study.scene, self._first_wording)
        others = (describe(self.study.scene, self._first_wording + n) for n in range(1, MAX_WORDINGS))
        return next((wording for wording in chain([first], others) if is_followable(wording.sentences)), first)

    @cached_property
    def words(self) -> Words:
        """Return the names and symbols in the scene's text, which questions use."""
        return words_of(self.description)

    def _words(self, told: "_WordedQuestion") -> Words:
        """Return the names and symbols in a question's own text, which may omit some numbers."""
        stated = told.description.told
        if len(stated) == len(self.description.told):
            return self.words
        symbols = {path: symbol for path, symbol in self.words.symbols.items() if path in stated}
        return replace(self.words, symbols=symbols)

    def _certified(self, query: Query, study: SimulatedScene) -> tuple[SimulatedScene, Certificate]:
        """Return the motion up to the time until which both engines agree, with the certificate."""
        time = KINDS[query.kind].time(query, study)
        trace = study.trace if time is None else study.trace.through(TIME_MARGIN * time)
        known = self._certified_motion if study is self.study else None
        if known is None or len(known[0].trace.state.times) < len(trace.state.times):
            seen, certificate = certify_trace(trace)
            known = SimulatedScene(study.scene, seen), certificate
        if study is self.study:
            self._certified_motion = known
        return known

    @cached_property
    def fault(self) -> str:
        """Return why every question about the scene would be rejected, as a manifest counts it; empty if not."""
        if self.is_unstable:
            return f"unstable: {self.study.trace.cut}"
        verdict = Verdict(keep=True, filter="") if self._unfiltered else filter_scene(self.study)
        if not verdict.keep:
            return verdict.manifest_name
        return "" if is_followable(self.description.sentences) else "length"

    @property
    def is_unstable(self) -> bool:
        """Return whether the engines fail early in the motion."""
        return self.study.trace.stable_until < MIN_CERTIFIED_FRACTION * float(self.study.trace.state.times[-1])

    def ask(
        self,
        mode: QuestionMode,
        rng: np.random.Generator,
        refused: Counter[str],
        kind: str = "",
        tries: int = MAX_QUESTIONS,
    ) -> CertifiedQuestion | None:
        """Return a question that passes every filter, or None; `refused` counts the rejections by filter.

        If a `kind` is given, a scene that does not offer it is not counted as a rejection.
        """
        if self.fault:
            refused[self.fault] += 1
            return None
        for question in self._questions(mode, kind, rng, refused, tries):
            outcome = self._judged(question, mode, rng)
            if isinstance(outcome, CertifiedQuestion):
                return outcome
            refused[outcome.manifest_name] += 1
        return None

    def certified(
        self,
        question: Question,
        mode: QuestionMode,
        rng: np.random.Generator,
        refused: Counter[str],
        beside: tuple[Candidate, ...],
    ) -> CertifiedQuestion | None:
        """Return a question certified by all filters; None if a filter rejects it, counted in `refused`."""
        outcome = self._judged(question, mode, rng, beside)
        if isinstance(outcome, CertifiedQuestion):
            return outcome
        refused[outcome.manifest_name] += 1
        return None

    def _judged(
        self, question: Question, mode: QuestionMode, rng: np.random.Generator, beside: tuple[Candidate, ...] = ()
    ) -> CertifiedQuestion | Verdict:
        """Return the question with its certificate, or the verdict against it."""
        outcome, candidate = self._examined(question, mode, rng, beside)
        if isinstance(outcome, Verdict) and self.on_refusal is not None:
            self.on_refusal(RefusedQuestion(candidate, outcome))
        return outcome

    def _examined(
        self, question: Question, mode: QuestionMode, rng: np.random.Generator, beside: tuple[Candidate, ...]
    ) -> tuple[CertifiedQuestion | Verdict, Candidate]:
        """Return the certified question or a filter's verdict against it, and the candidate that filters saw last."""
        prepared = self._told(question, mode, rng, beside)
        verdict = self._sift(prepared.candidate, witnessed=False)
        if verdict.keep:
            completed = mode.completed(question, self.study, self._words(prepared), rng)
            if completed is None:
                return Verdict(keep=False, filter=INCOMPLETE), prepared.candidate
            if completed is not question:
                prepared = self._told(completed, mode, rng, beside)
                verdict = self._sift(prepared.candidate, witnessed=False)
        candidate = prepared.candidate.checked if verdict.keep else prepared.candidate
        if candidate is not prepared.candidate:  # it needs other means
            verdict = self._sift(candidate, witnessed=False)
        if not verdict.keep:
            return verdict, candidate
        study, certificate = self._certified(question.query, candidate.study)
        last = replace(candidate, certificate=certificate)
        verdict = self._sift(last, witnessed=True)
        if not verdict.keep:
            return verdict, last
        return CertifiedQuestion(candidate, study, certificate, prepared.description, prepared.shape), last

    def described(self, questions: Sequence[Question]) -> Description:
        """Return the text for several questions, without the sentences that matter to none of them."""
        topics = self.description.topics
        idle = (irrelevant(question, self.study, topics) for question in questions)
        return self._without_topics(frozenset[Topic].intersection(*idle))

    def _told(
        self, question: Question, mode: QuestionMode, rng: np.random.Generator, beside: tuple[Candidate, ...]
    ) -> "_WordedQuestion":
        """Return a question with its prompt, ready for the filters."""
        study = mode.study(question, self.study)
        description = mode.described(
            question, self._without_topics(irrelevant(question, study, self.description.topics))
        )
        prompt = shaped(description, question, rng)
        sentences = description.sentences
        level: Difficulty = self._difficulty or "medium"
        candidate = Candidate(
            study,
            question,
            prompt.text,
            sentences,
            self.words,
            difficulty=level,
            tolerance=self._tolerance,
            needs=self._needs,
            labelled=self._difficulty is not None,
            easy=self.easy,
            beside=beside,
        )
        return _WordedQuestion(candidate, description, prompt.shape)

    def _without_topics(self, topics: frozenset[Topic]) -> Description:
        """Return the scene's text without sentences on some topics, cached because many questions omit the same."""
        if topics not in self._texts:
            self._texts[topics] = self.description.leaving_out(topics)
        return self._texts[topics]

    def _wants(self, query: Query) -> bool:
        """Return whether a query concerns an allowed quantity."""
        return KINDS[query.kind].measured(query).name in self._quantities

    @cached_property
    def _changing(self) -> bool:
        """Return whether accelerations change continuously, as with springs, and not only at events."""
        return bool(changing(self.study.mechanism))

    def _suits(self, query: Query, unknown: str, stated: StatedResult | None) -> bool:
        """Return whether the worked solution of a query needs only allowed mathematics.

        If no strategy applies to a query, none applies to an unknown number that its answer determines.
        """
        if self._needs == EVERY or not (unknown or self._changing or Need.ARITHMETIC not in self._needs):
            return True  # nearly all about constant accelerations is elementary, and the filter looks at it
        most = max(self._needs)
        hopeless = (
            unknown
            and most < Need.INTEGRATION
            and not shortest_solution(query, self.study, self.words, most=most).answer
        )
        suits = (
            not hopeless
            and shortest_solution(query, self.study, self.words, unknown, stated, most).needs in self._needs
        )
        self._refused |= not suits
        return suits

    def _questions(
        self, mode: QuestionMode, kind: str, rng: np.random.Generator, refused: Counter[str], tries: int
    ) -> Iterator[Question]:
        """Yield distinct random questions; fewer if the motion offers no more."""
        seen, missed = set[tuple[Query, str]](), 0
        if kind and not may_have_solution(kind, self.study, max(self._needs)):
            return
        for _ in range(DRAWS * tries // MAX_QUESTIONS * (DRAW_FACTOR if self._quantities else 1)):
            self._refused = False
            question = mode.ask(self.study, self.words, kind, rng, self._suits)
            if question is None and self._refused:
                self.beyond.add(kind)
                refused[UNSUITED] += 1
                return
            if question is not None and self._quantities and not self._wants(question.query):
                continue
            if question is None:
                missed += 1
                if not kind:
                    refused[NOTHING] += 1
                if missed == MISSES:
                    return
                continue
            self.kinds.add(kind)
            if (question.query, question.unknown) not in seen:
                seen.add((question.query, question.unknown))
                yield question
            if len(seen) >= tries:
                return
