"""Recipes of one entity: each difficulty is a choice of ideas, and an idea narrows how the entity is drawn."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from sim2reason.dsl.entity import ENTITIES, Named
from sim2reason.dsl.model import Choice, Choices, draw
from sim2reason.dsl.scene import Scene
from sim2reason.dsl.vacancies import vacated


@dataclass(frozen=True)
class Idea:
    """What a problem is about: the type of its entity, what its numbers and parts are drawn from, and how often."""

    entity: str
    choices: Choices = field(default_factory=dict[str, Choice])
    weight: float = 1.0


def one_of(ideas: Sequence[Idea], rng: np.random.Generator, name: str) -> Scene:
    """A scene of one entity, called `name` in its file, drawn by one of the ideas.

    Raises:
        SceneError: the draw does not hold together.
    """
    weights = np.array([idea.weight for idea in ideas])
    idea = ideas[int(rng.choice(len(ideas), p=weights / weights.sum()))]
    return Scene(entities=vacated((Named(name=name, entity=draw(ENTITIES[idea.entity], rng, idea.choices)),), ()))
