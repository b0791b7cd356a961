"""Settings of worked solutions: of drawn problems, and of questions about plain scenes."""

from collections import Counter
from collections.abc import Iterator, Sequence

from sim2reason.datasets.items import item
from sim2reason.datasets.question_search import QuestionSearch
from sim2reason.datasets.random_scenes import generator
from sim2reason.dsl.entity import Entity, Named
from sim2reason.dsl.scene import Scene
from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.questions import MODES, Query
from sim2reason.questions.parse_question import parse_question
from sim2reason.recipes import RECIPES, difficulty_named
from sim2reason.solutions import Setting, Solution, solve
from sim2reason.testing.solutions.faults import faults
from sim2reason.testing.solutions.reading import read

TRIES = 40
ANSWERED = ("start", "state", "event", "time_to_event")  # kinds that strategies have a way to


def setting_of(search: QuestionSearch, query: Query) -> Setting:
    study = search.study
    return Setting(study.scene, search.words, search.description.symbols, study, query)


def solution_text(recipe: str, difficulty: str, mode: str, index: int, seed: int = 301914) -> str:
    """Return the worked solution of one generated problem, as its text."""
    found = item(recipe=recipe, difficulty=difficulty, mode=mode, seed=seed, index=index, solutions=True)
    assert found.solution is not None, found.unsolved
    return found.solution.text


def asked(scene: Scene, question: str | Query) -> Setting:
    """A question about a scene, in the words of the library or as a query."""
    search = QuestionSearch(scene, 0)
    query = question if isinstance(question, Query) else parse_question(question, search.study, search.words)
    assert query is not None, question
    return setting_of(search, query)


def derived(scene: Scene, query: Query) -> Solution:
    """Return the derivation of an answer, every check passed, its text alone included."""
    setting = asked(scene, query)
    found = solve(setting)
    assert found.answer is not None, found.reason
    assert found.derived, found.strategy
    assert setting.answer is not None
    assert not faults(found, setting.answer), found.text
    reading = read(found.text)
    assert not reading.unread
    assert not reading.broken, reading.broken
    return found


def answer(name: str, entity: Entity, query: Query) -> float:
    """Return what is derived about a lone entity."""
    found = derived(Scene(entities=(Named(name=name, entity=entity),)), query)
    assert found.answer is not None
    return found.answer


def problems(
    recipe: str, difficulty: str, count: int, seed: int = 3, kinds: Sequence[str] = ANSWERED
) -> Iterator[Setting]:
    """Drawn problems that pass every filter, of each kind that strategies answer in turn."""
    for index in range(count):
        found = _problem(recipe, difficulty, seed, index, kinds)
        if found is not None:
            yield found


def _problem(recipe: str, difficulty: str, seed: int, index: int, kinds: Sequence[str]) -> Setting | None:
    for attempt in range(TRIES):
        rng = generator("worked", recipe, difficulty, seed, index, attempt)
        try:
            search = QuestionSearch(RECIPES[recipe](difficulty_named(difficulty), rng), int(rng.random() * 2**31))
            kind = kinds[index % len(kinds)]
            found = search.ask(MODES["numeric"], rng, Counter[str](), kind)
        except (SceneError, SimulationError, UnsupportedError):
            continue
        if found is not None:
            return setting_of(search, found.question.query)
    return None
