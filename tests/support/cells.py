"""Samples for acceptance tests: scenes and questions of every recipe in every difficulty."""

from collections import Counter
from collections.abc import Iterator
from itertools import count

from sim2reason.errors import SceneError, SimulationError, UnsupportedError
from sim2reason.generation.certified import CertifiedQuestion
from sim2reason.generation.item_search import generator, sample
from sim2reason.generation.question_search import QuestionSearch
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions import MODES
from sim2reason.questions.difficulty import DIFFICULTIES, Difficulty
from sim2reason.scenes.dsl.scene import Scene

CELLS = [(recipe, difficulty) for recipe in RECIPES for difficulty in DIFFICULTIES]


def drawn(recipe: str, difficulty: Difficulty, number: int, seed: int = 11) -> Iterator[Scene]:
    """Return the first scenes of a cell, unfiltered."""
    return (sample(recipe, difficulty, seed=seed, index=index) for index in range(number))


def asked(recipe: str, difficulty: Difficulty, seed: int = 11) -> Iterator[tuple[Scene, CertifiedQuestion]]:
    """Yield without end questions of a cell that passed every filter, each with its scene."""
    for attempt in count():
        rng = generator("acceptance", recipe, difficulty, seed, attempt)
        try:
            scene = RECIPES[recipe](difficulty, rng)
            found = QuestionSearch(scene, attempt).ask(MODES["numeric"], rng, Counter())
        except (SceneError, SimulationError, UnsupportedError):
            continue
        if found is not None:
            yield scene, found
