"""Thrown balls, which may bounce."""

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.parts.ideas import Idea, one_of
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.measures import Range
from sim2reason.scenes.dsl.scene import Scene

KIND = "Projectile"
THROWN = {"height": Range(1.0, 5.0), "speed": Range(3.0, 12.0), "angle": Range(15.0, 75.0)}
BOUNCING = {**THROWN, "restitution?": 1.0, "restitution": Range(0.3, 0.85)}
FLYING = {**THROWN, "restitution?": 0.0}
IDEAS = {
    "easy": (  # thrown horizontally it would only fall, were it not to bounce
        Idea(KIND, {**FLYING, "side": ("above",)}, 2.0),
        Idea(KIND, {**BOUNCING, "angle": 0.0}),
    ),
    "medium": (  # one flight after another, or one that begins downwards
        Idea(KIND, BOUNCING, 2.0),
        Idea(KIND, {**FLYING, "side": ("below",), "angle": Range(15.0, 75.0)}),
    ),
    "hard": (  # so lively that the flights add up, or thrown at the ground
        Idea(KIND, {**BOUNCING, "speed": Range(4.0, 10.0), "restitution": Range(0.6, 0.95)}),
        Idea(KIND, {**BOUNCING, "speed": Range(3.0, 10.0), "side": ("below",), "angle": Range(15.0, 75.0)}),
    ),
}


@recipe("projectile", weights={"extremum": 0.03, "state": 0.5, "optimum": 2.0})  # which hang on few of the numbers
def draw_projectile(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A ball thrown from a height, which may bounce."""
    return one_of(IDEAS[difficulty], rng, "throw")
