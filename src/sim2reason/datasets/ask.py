"""Questions about a scene that is given, each as an item: what `ask` is, in Python and as a command."""

from collections import Counter
from dataclasses import dataclass, field

from sim2reason.datasets.item import Item
from sim2reason.datasets.make import item_of
from sim2reason.datasets.names import modes_named
from sim2reason.datasets.plan import Names, Request
from sim2reason.datasets.question_search import CertifiedQuestion, QuestionSearch
from sim2reason.datasets.random_scenes import generator
from sim2reason.dsl.scene import Scene
from sim2reason.questions import MODES

QUESTIONS = 5
TRIES = 10  # for each question that is wanted


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
    """The same with the scene's text, and with what was refused; modes take turns."""
    modes, search = modes_named(mode), QuestionSearch(scene, seed)
    result = AskedScene(search.description.text)
    for attempt in range(TRIES * items):
        if len(result.found) >= items:
            break
        name = modes[attempt % len(modes)]
        certified = search.ask(MODES[name], generator("ask", name, seed, attempt), result.refused)
        if certified is not None and certified.question.text not in result.found:
            item = item_of(Request("", "", name, seed, attempt), certified)
            named = item.model_copy(update={"id": f"{scene.name}-{name}-{seed}-{attempt}"})
            result.found[certified.question.text] = certified, named
    return result
