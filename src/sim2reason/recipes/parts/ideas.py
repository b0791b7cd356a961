"""Recipes of one entity: each difficulty is a choice of ideas, and an idea narrows how the entity is drawn."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from sim2reason.dsl.entity import ENTITIES, Named
from sim2reason.dsl.model import Choice, Choices, draw
from sim2reason.dsl.scene import Scene
from sim2reason.dsl.vacancies import vacated
from sim2reason.errors import SceneError

REDRAWS = 200  # of what does not suit an idea


@dataclass(frozen=True)
class Idea:
    """What a problem is about: the type of its entity, what its numbers and parts are drawn from, and how often."""

    entity: str
    choices: Choices = field(default_factory=dict[str, Choice])
    weight: float = 1.0
    suits: Callable[[Any], bool] = lambda _: True  # whether all of a drawn entity has a bearing on what it does


def one_of(ideas: Sequence[Idea], rng: np.random.Generator, name: str) -> Scene:
    """A scene of one entity, called `name` in its file, drawn by one of the ideas.

    Raises:
        SceneError: the draw does not hold together, or nothing that was drawn suits the idea.
    """
    weights = np.array([idea.weight for idea in ideas])
    idea = ideas[int(rng.choice(len(ideas), p=weights / weights.sum()))]
    for _ in range(REDRAWS):
        entity = draw(ENTITIES[idea.entity], rng, idea.choices)
        if idea.suits(entity):
            return Scene(entities=vacated((Named(name=name, entity=entity),), ()))
    raise SceneError(idea.entity, f"none of {REDRAWS} draws suits what the recipe is about", "widen a range")
