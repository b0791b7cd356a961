"""Carts joined by springs in a row, and beads joined by springs in a ring."""

import numpy as np

from sim2reason.dsl.measures import Count
from sim2reason.dsl.scene import Scene
from sim2reason.recipes import Difficulty, recipe
from sim2reason.recipes.parts.ideas import Idea, one_of

KIND, RING = "SpringMassChain", "SpringMassRing"
LEVEL = {"tilt?": 0.0, "friction?": 0.0, "damping?": 0.0}
IDEAS = {
    "easy": (  # one cart on one or two springs, or two carts on one
        Idea(KIND, {**LEVEL, "carts": Count(1, 1), "ends": ("left", "right", "both")}),
        Idea(KIND, {**LEVEL, "carts": Count(2, 2), "ends": ("free",)}),
    ),
    "medium": (  # two modes, a slope, or friction
        Idea(KIND, {**LEVEL, "carts": Count(2, 3), "ends": ("left", "right", "both")}, 2.0),
        Idea(KIND, {**LEVEL, "carts": Count(1, 2), "ends": ("left", "right"), "tilt?": 1.0}),
        Idea(KIND, {**LEVEL, "carts": Count(1, 1), "ends": ("left", "right"), "friction?": 1.0}),
        Idea(RING, {"beads": Count(2, 3), "damping?": 0.0}, 0.7),
    ),
    "hard": (
        Idea(KIND, {**LEVEL, "carts": Count(3, 6)}, 2.0),
        Idea(KIND, {**LEVEL, "carts": Count(2, 3), "damping?": 1.0}),
        Idea(KIND, {**LEVEL, "carts": Count(2, 3), "friction?": 1.0}),
        Idea(RING, {"beads": Count(3, 5)}, 0.7),
    ),
}


@recipe("chain")
def draw_chain(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Carts on a track, or beads on a ring, with springs between them: struck, or let go with a spring strained."""
    return one_of(IDEAS[difficulty], rng, "chain")
