"""A puck on a table, held by springs at angles."""

import numpy as np

from sim2reason.dsl.measures import Count, Range
from sim2reason.dsl.scene import Scene
from sim2reason.recipes import Difficulty, recipe
from sim2reason.recipes.parts.ideas import Idea, one_of

KIND = "SpringBlock"
EVEN = {"stiffness": Range(50.0, 200.0)}  # so that each of them counts
IDEAS = {
    "easy": (  # two springs, released, or one, of which energy alone says much
        Idea(KIND, {"springs": Count(1, 1), "damping?": 0.0, "launch?": 0.3}, 0.5),
        Idea(KIND, {"springs": Count(2, 2), "damping?": 0.0, "launch?": 0.0}),
    ),
    "medium": (Idea(KIND, {**EVEN, "springs": Count(2, 2), "damping?": 0.0, "launch?": 0.7}),),
    "hard": (  # friction of the springs themselves
        Idea(KIND, {**EVEN, "springs": Count(3, 3), "damping?": 0.6, "damping": Range(2.0, 8.0), "launch?": 0.6}),
    ),
}


@recipe("springs", share=2)
def draw_springs(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A block on a smooth table that several springs pull from different sides."""
    return one_of(IDEAS[difficulty], rng, "springs")
