"""Questions about a scene that is given, each as an item: what `ask` is, in Python and as a command."""

from collections import Counter
from dataclasses import dataclass, field
from itertools import islice

from sim2reason.datasets.certified import CertifiedQuestion
from sim2reason.datasets.forms import formed
from sim2reason.datasets.item import Item
from sim2reason.datasets.make import item_of
from sim2reason.datasets.names import modes_named
from sim2reason.datasets.plan import Names
from sim2reason.datasets.question_search import QuestionSearch
from sim2reason.datasets.random_scenes import generator
from sim2reason.datasets.request import Request
from sim2reason.datasets.splits import problem
from sim2reason.dsl.scene import Scene
from sim2reason.questions import MODES

QUESTIONS = 5
TRIES = 10  # for each question that is wanted
SPARE = 2  # times the questions that are wanted: so many with their variants end the search


@dataclass
class AskedScene:
    """A scene's text, and the questions about it that passed every filter, each in its item."""

    text: str
    found: dict[str, tuple[CertifiedQuestion, Item]] = field(default_factory=dict[str, tuple[CertifiedQuestion, Item]])
    """By the question's own words."""
    refused: Counter[str] = field(default_factory=Counter[str])
    """By filter."""


def ask(scene: Scene, *, mode: Names = "numeric", items: int = QUESTIONS, seed: int = 0) -> list[Item]:
    """At most so many problems about one scene, those that pass every filter; another seed asks others.

    They are items as a dataset has them, but of no recipe and no difficulty.

    Raises:
        UnknownNameError: no such mode.
        SceneError, UnsupportedError, SimulationError: the scene can not be built, modelled or solved.
    """
    return [item for _, item in asked(scene, mode, items, seed).found.values()]


def asked(scene: Scene, mode: Names, items: int, seed: int) -> AskedScene:
    """The same with the scene's text, and with what was refused; modes take turns.

    One problem with other numbers is asked again only where there are too few others.
    """
    modes, search = modes_named(mode), QuestionSearch(scene, seed)
    result = AskedScene(search.description.text)
    problems, variants = set[str](), dict[str, tuple[CertifiedQuestion, Item]]()
    for attempt in range(TRIES * items):
        if len(result.found) >= items or len(result.found) + len(variants) >= SPARE * items:
            break
        name = modes[attempt % len(modes)]
        rng, base = generator("ask", name, seed, attempt), f"{scene.name}-{name}-{seed}"
        certified = search.ask(MODES[name], rng, result.refused)
        if certified is not None:
            certified = formed(certified, search, MODES[name], "medium", rng, result.refused, f"{base}-{attempt}")
        if certified is not None and certified.question.text not in result.found:
            item = item_of(Request("", "", name, seed, attempt), certified)
            named = item.model_copy(update={"id": f"{base}-{attempt}"})
            kept = variants if problem(named) in problems else result.found
            kept[certified.question.text] = certified, named
            problems.add(problem(named))
    result.found.update(islice(variants.items(), items - len(result.found)))
    return result
