"""Rockets."""

import numpy as np

from sim2reason.dsl.scene import Scene
from sim2reason.recipes import Difficulty, recipe
from sim2reason.recipes.parts.ideas import Idea, one_of

KIND = "RocketEntity"
IDEAS = {
    "easy": (Idea(KIND, {"place": ("DeepSpace",)}),),
    "medium": (Idea(KIND, {"place": ("LevelGround",)}),),  # with weight, and perhaps a wait until it can lift off
    "hard": (Idea(KIND, {"place": ("AirlessPlanet",)}),),  # with a weight that falls off
}


@recipe("rocket", weights={"time_to_event": 0.3})  # which are often about a minute
def draw_rocket(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A rocket that burns its fuel: in deep space, above level ground, from a planet that really pulls."""
    return one_of(IDEAS[difficulty], rng, "rocket")
