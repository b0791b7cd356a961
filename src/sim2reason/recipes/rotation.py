"""Rigid bodies that swing about an axle."""

import numpy as np

from sim2reason.dsl.measures import Count
from sim2reason.dsl.scene import Scene
from sim2reason.recipes import Difficulty, recipe
from sim2reason.recipes.parts.ideas import Idea, one_of

KIND = "RotationEntity"
IDEAS = {
    "easy": (Idea(KIND, {"pieces": Count(1, 1)}),),
    "medium": (  # several pieces, or one that is pushed
        Idea(KIND, {"pieces": Count(2, 3)}, 2.0),
        Idea(KIND, {"pieces": Count(1, 1), "rate?": 1.0}),
    ),
    "hard": (  # several pieces that are pushed, so that they may go over the top
        Idea(KIND, {"pieces": Count(2, 4)}),
        Idea(KIND, {"pieces": Count(2, 3), "rate?": 1.0}, 2.0),
    ),
}


@recipe("rotation", share=2)
def draw_rotation(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Up to four solid bodies fixed to a light arm: let go, or set turning."""
    return one_of(IDEAS[difficulty], rng, "arm")
