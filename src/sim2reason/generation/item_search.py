"""Search for an item: scenes and questions are drawn until one question passes every filter."""

import hashlib
import json
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

import numpy as np

from sim2reason.errors import DrawError, SceneError, SimulationError, UnsupportedError
from sim2reason.generation.certified import CertifiedQuestion
from sim2reason.generation.filters.texts import COUNTED
from sim2reason.generation.filters.well_known import FEW_LAWS
from sim2reason.generation.item import Answer
from sim2reason.generation.options import MAX_DISTRACTORS, distractors, options, options_of_two
from sim2reason.generation.part_search import PartSearch
from sim2reason.generation.question_search import NOTHING, UNSUITED, QuestionSearch, RefusedQuestion
from sim2reason.generation.recipes import RECIPES, find_difficulty
from sim2reason.generation.request import Request, random_kind_order
from sim2reason.questions import KINDS, MODES, QuestionMode
from sim2reason.questions.difficulty import ELEMENTARY, EVERY, NEEDS, Difficulty, Need
from sim2reason.scenes.dsl.scene import Scene

TRIES = 50


def generator(*key: object) -> np.random.Generator:
    """Return a random generator seeded by the hash of a key, independent of that of any other key."""
    digest = hashlib.sha256(json.dumps(["sim2reason", *key]).encode()).digest()
    return np.random.default_rng(int.from_bytes(digest, "big"))


def sample(recipe: str, difficulty: str = "medium", *, seed: int = 0, index: int = 0) -> Scene:
    """Draw the `index`-th scene of a recipe, difficulty and seed; invalid draws are repeated.

    Raises:
        UnknownNameError: no such recipe or difficulty.
        DrawError: nothing fitted together within the budget.
    """
    draw = RECIPES[recipe]
    checked = find_difficulty(difficulty)
    for attempt in range(TRIES):
        try:
            scene = draw(checked, generator("scene", recipe, difficulty, seed, index, attempt))
            scene.check()
        except SceneError:
            continue
        return scene
    raise DrawError(f"{recipe} {difficulty} {seed} {index}: no scene fitted together; take another index")


EVERY_NEED_PROBABILITY = 0.08
"""Of the requests that may be filled by items which need more than `ELEMENTARY`; not all of them are."""
SIMPLE = frozenset(need for need in Need if need <= ELEMENTARY)


def allowed_needs(request: Request) -> frozenset[Need]:
    """Return the mathematics that solutions may need: as requested, else elementary, or any for a random 8 %."""
    if request.needs:
        return frozenset(NEEDS[name] for name in request.needs)
    if request.unfiltered:
        return EVERY
    coordinates = request.recipe, request.difficulty, request.mode, request.seed, request.index
    return EVERY if generator(*coordinates, "needs").random() < EVERY_NEED_PROBABILITY else SIMPLE


FEW_OPTIONS = "options: too few wrong answers"


def form_problem(
    certified: CertifiedQuestion,
    search: QuestionSearch,
    mode: QuestionMode,
    difficulty: Difficulty,
    rng: np.random.Generator,
    refused: Counter[str],
    name: str,
) -> CertifiedQuestion | None:
    """Return a question as a problem of a mode, with parts or options; None, counted in `refused`, if impossible.

    The order of options depends only on `name`.
    """
    if mode.several:
        return PartSearch(search, mode, difficulty, rng, refused).around(certified)
    if not mode.offers_options:
        return certified
    question = certified.question
    answer = Answer(
        value=question.answer, unit=question.unit, sign=question.sign, tolerance=certified.candidate.tolerance
    )
    if certified.candidate.kind.names_one:
        chosen = options_of_two(answer, distractors(certified.candidate, certified.description), name)
    else:
        chosen = options(answer, distractors(certified.candidate, certified.description, MAX_DISTRACTORS), name)
    if chosen is None:
        refused[FEW_OPTIONS] += 1
        return None
    return replace(certified, options=chosen)


MAX_SCENES = 60  # drawn for one item, at most
SCENES_PER_KIND = 2  # scenes tried with one question kind before the next kind
QUESTIONS_PER_SCENE = 2  # questions of one kind about one scene
MAX_EMPTY_SCENES = 40  # scenes without any question after which the search ends
OTHER_KIND_ROUNDS = 3  # rounds of other kinds on the same scenes before new ones are drawn
MAX_FEW_LAWS = 4  # questions of a kind rejected for few laws after which the kind is tried last
MAX_REFUSALS = 6  # questions of a kind rejected by any filter after which the kind is tried last
MAX_UNFIT_DRAWS = 120  # draws of a kind that all need disallowed means after which the search gives up
MAX_HOPELESS_DRAWS = 2  # draws of a kind that all need disallowed means after which the kind is tried last
MAX_UNFIT_KINDS = 2  # kinds needing disallowed means after which a scene is abandoned
MAX_ABSENT_SCENES = 3  # scenes that do not offer a kind after which the kind is tried last
SETTINGS = (
    MAX_SCENES,
    SCENES_PER_KIND,
    QUESTIONS_PER_SCENE,
    OTHER_KIND_ROUNDS,
    MAX_EMPTY_SCENES,
    MAX_FEW_LAWS,
    MAX_REFUSALS,
    MAX_UNFIT_DRAWS,
    MAX_HOPELESS_DRAWS,
    MAX_UNFIT_KINDS,
    MAX_ABSENT_SCENES,
)

Drawn = tuple[QuestionSearch, np.random.Generator]


class ItemSearch:
    """The search for one item, with a random order of question kinds by weight.

    Each scene is tried with the first kind in the order that it offers. If a few scenes fail, the same scenes, already
    simulated, are tried with other kinds, and the next scenes start with the next kind. Hence kinds that rarely pass
    the filters are kept almost as often as others. A kind whose answers are textbook ones is not retried on the next
    scene.
    """

    def __init__(self, request: Request) -> None:
        """Store the request; UnknownNameError for an unknown name in it."""
        self._request, self._mode, self._recipe = request, MODES[request.mode], RECIPES[request.recipe]
        self._difficulty: Difficulty = find_difficulty(request.difficulty)
        self._kinds = random_kind_order(request.mode, request.recipe, request.weights, self._generator("kinds"))
        self._needs = allowed_needs(request)
        self.on_refusal: Callable[[RefusedQuestion], None] | None = None  # called with each question that is refused
        self.rejected: Counter[str] = Counter()
        self._known: Counter[str] = Counter()  # questions that few laws answer, by kind
        self._refused: Counter[str] = Counter()  # questions that are refused, by kind
        self._unsuited: Counter[str] = Counter()  # scenes about which all its draws need other means, by kind
        self._absent: Counter[str] = Counter()  # scenes that do not offer it, by kind
        self._searches: list[QuestionSearch] = []
        self._first = ""  # the first kind of its order that a scene offers
        self._problems = set[str]()  # kinds with a question of which no textbook has the answer ready

    def release(self) -> None:
        """Discard what is cached about all scenes, when nothing more is asked about the question that was found."""
        for search in self._searches:
            search.release()
        self._searches.clear()

    @property
    def first_kind(self) -> str:
        """Return the question kind tried first; empty if it only gave questions answered in textbooks."""
        return self._first if self._first in self._problems else ""

    def find(self) -> CertifiedQuestion | None:
        """Return the first question that passes every filter; None if none does within the budget."""
        for turn, first in enumerate(range(0, MAX_SCENES, SCENES_PER_KIND)):
            certified = self._among(range(first, first + SCENES_PER_KIND), self._order(turn))
            hopeless = not self._first and self.rejected[NOTHING] >= MAX_EMPTY_SCENES
            hopeless = hopeless or self.rejected[UNSUITED] >= MAX_UNFIT_DRAWS
            if certified is not None or hopeless:
                return certified
        return None

    def _order(self, turn: int) -> list[str]:
        """Return the question kinds in the order in which one round tries them; each round begins with another kind.

        An expensive kind is tried only in the round that begins with it.
        """
        begin = turn % len(self._kinds)
        first, *others = *self._kinds[begin:], *self._kinds[:begin]
        others = [kind for kind in others if not KINDS[kind].costly]
        return sorted((first, *others), key=self._is_last)

    def _is_last(self, kind: str) -> bool:
        """Return whether a kind is tried last: seldom possible, mostly rejected, or needing disallowed mathematics."""
        known = self._known[kind] >= MAX_FEW_LAWS or self._absent[kind] >= MAX_ABSENT_SCENES
        return known or self._refused[kind] >= MAX_REFUSALS or self._unsuited[kind] >= MAX_HOPELESS_DRAWS

    def _among(self, attempts: range, kinds: Sequence[str]) -> CertifiedQuestion | None:
        """Return a question that passes all filters, about one of several drawn scenes; None if there is none."""
        drawn: list[Drawn] = []
        for search, rng in self._scenes(attempts):
            drawn.append((search, rng))
            certified = self._first_kind(search, rng, kinds)
            if certified is not None:
                return certified
        turns = 0
        for kind in kinds:
            for search, rng in drawn:
                if kind in search.kinds or kind in search.beyond or len(search.beyond) >= MAX_UNFIT_KINDS:
                    continue
                certified = self._ask_kind(search, rng, kind)
                turns += kind in search.kinds or kind in search.beyond
                if certified is not None or turns == OTHER_KIND_ROUNDS:
                    return certified
        return None

    def _scenes(self, attempts: range) -> Iterator[Drawn]:
        """Draw scenes, and yield those about which questions can pass the filters."""
        for attempt in attempts:
            rng = self._generator(attempt)
            try:
                scene = self._recipe(self._difficulty, rng)
                if not self._mode.offers(scene.mechanism):
                    self.rejected[NOTHING] += 1
                    continue
                search = QuestionSearch(
                    scene,
                    int(rng.random() * 2**31),
                    self._difficulty,
                    unfiltered=self._request.unfiltered,
                    quantities=frozenset(self._request.quantities),
                    tolerance=self._request.tolerance,
                    needs=self._needs,
                )
            except (SceneError, SimulationError, UnsupportedError) as error:
                self.rejected[_counted(error)] += 1
                continue
            if search.fault:
                self.rejected[search.fault] += 1
            else:
                search.on_refusal = self.on_refusal
                self._searches.append(search)
                yield search, rng

    def _first_kind(
        self, search: QuestionSearch, rng: np.random.Generator, kinds: Sequence[str]
    ) -> CertifiedQuestion | None:
        """Return a question of the first kind that a scene allows, or None if that kind or every kind fails."""
        for kind in kinds:
            if len(search.beyond) >= MAX_UNFIT_KINDS:
                return None
            certified = self._ask_kind(search, rng, kind)
            if kind in search.kinds:
                self._first = self._first or kind
                return certified
            self._absent[kind] += 1
        self.rejected[NOTHING] += 1
        return None

    def _ask_kind(self, search: QuestionSearch, rng: np.random.Generator, kind: str) -> CertifiedQuestion | None:
        refused, certified = Counter[str](), None
        try:
            certified = search.ask(self._mode, rng, refused, kind, QUESTIONS_PER_SCENE)
            if certified is not None:
                name = self._request.id
                certified = form_problem(certified, search, self._mode, self._difficulty, rng, refused, name)
        except (SceneError, SimulationError, UnsupportedError) as error:
            refused[_counted(error)] += 1
        self._known[kind] += refused[FEW_LAWS]
        self._refused[kind] += refused.total()
        self._unsuited[kind] += refused[UNSUITED]
        if certified is not None or refused.keys() - {FEW_LAWS, *COUNTED}:
            self._problems.add(kind)
        self.rejected.update(refused)
        return certified

    def _generator(self, name: object) -> np.random.Generator:
        request = self._request
        return generator(request.recipe, request.difficulty, request.mode, request.seed, request.index, name)


def _counted(error: Exception) -> str:
    """Return the name under which a manifest counts an error."""
    return type(error).__name__.removesuffix("Error").lower()
