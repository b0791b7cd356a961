"""Rockets."""

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.parts.ideas import Idea, one_of
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.authoring import GRAVITY
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.space import RocketEntity

KIND = "RocketEntity"


def _waits(rocket: RocketEntity) -> bool:
    """Return whether the thrust cannot lift the rocket before some fuel is burnt."""
    return rocket.thrust < rocket.rocket.mass * GRAVITY


IDEAS = {
    "easy": (Idea(KIND, {"place": ("DeepSpace",)}),),
    "medium": (  # with weight, often with a wait until it can lift off
        Idea(KIND, {"place": ("LevelGround",)}, 0.6),
        Idea(KIND, {"place": ("LevelGround",)}, suits=_waits),
    ),
    "hard": (  # with a weight that falls off, or too heavy to lift off at once
        Idea(KIND, {"place": ("AirlessPlanet",)}, 2.0),
        Idea(KIND, {"place": ("LevelGround",)}, suits=_waits),
    ),
}

WEIGHTS = {
    "time_to_event": 0.2,  # which are often about a minute
    "state": 0.4,
    "extremum": 0.03,
    "optimum": 0.0,
}


@recipe("rocket", weights=WEIGHTS)
def draw_rocket(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A rocket that burns its fuel: in deep space, above level ground, or leaving a planet."""
    return one_of(IDEAS[difficulty], rng, "rocket")
