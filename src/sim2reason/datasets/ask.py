"""Questions about a given scene as items: the function and command `ask`."""

from collections import Counter
from collections.abc import Hashable
from dataclasses import dataclass, field
from itertools import islice

from sim2reason.datasets.plan import Names, modes_named
from sim2reason.generation.certified import CertifiedQuestion
from sim2reason.generation.item import Item
from sim2reason.generation.item_search import form_problem
from sim2reason.generation.make import item_of
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.random_scenes import generator
from sim2reason.generation.request import Request
from sim2reason.generation.splits import problem
from sim2reason.questions import MODES, Question
from sim2reason.questions.following import simulate_scene, simulate_until_event
from sim2reason.questions.kinds.threshold import ThresholdQuery
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import SceneLike, scene_of
from sim2reason.simulation.trace import ending

QUESTIONS = 5
TRIES = 10  # per requested question, and again for easy ones
SAME_ANSWER = "an answer that another question has"  # name of this rejection in counts
SPARE = 2  # times the requested questions, including variants, after which the search ends


@dataclass
class AskedScene:
    """The text of a scene, and the items of its questions that passed every filter."""

    text: str
    found: dict[str, tuple[CertifiedQuestion, Item]] = field(default_factory=dict[str, tuple[CertifiedQuestion, Item]])
    """The questions that passed, by their text, each with its item."""
    refused: Counter[str] = field(default_factory=Counter[str])
    """The number of questions refused by each filter."""
    reason: str = ""
    """The reason why no question can be asked about the scene, as a clause; empty where none is known."""


def ask(
    scene: SceneLike,
    *,
    mode: Names = "numeric",
    items: int = QUESTIONS,
    seed: int = 0,
    all: bool = False,  # noqa: A002 - as the option is called
) -> list[Item]:
    """Ask questions about a scene.

    No two of the problems have the same answer. Easy problems, which take few laws to solve, are only asked if there
    are too few others.

    Args:
        scene: A scene, the path of its file, its YAML text, an item about it, or the result of `parse_scene`.
        mode: Modes of questions, which take turns: one name, several, or ``all``.
        items: Greatest number of problems.
        seed: Seed of the questions and of their wording.
        all: Whether to keep problems that a filter rejects, such as easy, odd or uncertain ones.

    Returns:
        Items as in a dataset, but without a recipe and a difficulty; possibly fewer than `items`.

    Raises:
        TypeError: `scene` is of another type.
        UnknownNameError: There is no such mode.
        SceneError, UnsupportedError, SimulationError: The scene cannot be built, modelled or solved.

    Examples:
        >>> import sim2reason
        >>> scene = sim2reason.sample("incline", "easy")
        >>> problems = sim2reason.ask(scene, items=2)
        >>> [problem.id for problem in problems]
        ['scene-numeric-0-...', 'scene-numeric-0-...']
    """
    return [item for _, item in asked(scene_of(scene, "ask"), mode, items, seed, unfiltered=all).found.values()]


def asked(scene: Scene, mode: Names, items: int, seed: int, *, unfiltered: bool = False) -> AskedScene:
    """Return the items and text of a scene with the counts of rejections; modes alternate.

    A problem that differs only in its numbers is repeated only if there are too few others.
    """
    modes = modes_named(mode)
    search = QuestionSearch(simulate_until_event(simulate_scene(scene)).study, seed, unfiltered=unfiltered)
    result = AskedScene(search.description.text)
    problems, variants = set[str](), dict[str, tuple[CertifiedQuestion, Item]]()
    answers = set[Hashable]()
    for attempt in range(2 * TRIES * items):
        if len(result.found) >= items or len(result.found) + len(variants) >= SPARE * items:
            break
        search.easy = attempt >= TRIES * items
        name = modes[attempt % len(modes)]
        rng, base = generator("ask", name, seed, attempt), f"{scene.name}-{name}-{seed}"
        certified = search.ask(MODES[name], rng, result.refused)
        if certified is not None:
            certified = form_problem(certified, search, MODES[name], "medium", rng, result.refused, f"{base}-{attempt}")
        if certified is not None and certified.question.text not in result.found:
            item = item_of(Request("", "", name, seed, attempt), certified)
            answer = _answer(certified.question, item)
            if answer in answers:
                result.refused[SAME_ANSWER] += 1
                continue
            answers.add(answer)
            named = item.model_copy(update={"id": f"{base}-{attempt}"})
            kept = variants if problem(named) in problems else result.found
            kept[certified.question.text] = certified, named
            problems.add(problem(named))
    if search.is_unstable:
        unit = scene.units.time
        result.reason = f"the motion ends at {search.study.trace.stable_until:.3g} {unit}: {ending(search.study.trace)}"
    result.found.update(islice(variants.items(), items - len(result.found)))
    return result


def _answer(question: Question, item: Item) -> Hashable:
    """Return a key, usually the answer, that no two questions about a scene may share.

    For an unknown number the key includes its address. If the scene's own value is the answer, as for the mass that
    gives a stated speed, the key is the query.
    """
    if not question.unknown:
        return item.answer.shown
    threshold = isinstance(question.query, ThresholdQuery)
    return question.unknown, item.answer.shown if threshold else question.query
