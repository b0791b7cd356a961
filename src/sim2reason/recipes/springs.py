"""A puck on a table, held by springs at angles, and a block on a rough plane at the end of one spring."""

import numpy as np

from sim2reason.dsl.measures import Count, Range
from sim2reason.dsl.scene import Scene
from sim2reason.recipes import Difficulty, recipe
from sim2reason.recipes.parts.ideas import Idea, one_of

KIND, PLANE = "SpringBlock", "SpringMassIncline"
# one spring from the origin: energy and angular momentum are kept
CENTRAL = {"springs": Count(1, 1), "NailedSpring.x": 0.0, "NailedSpring.y": 0.0, "damping?": 0.0, "launch?": 1.0}
EVEN = {"stiffness": Range(50.0, 200.0)}  # so that each of them counts
ROUGH = {"stiffness": Range(40.0, 160.0), "mass": Range(0.5, 2.0), "friction": Range(0.25, 0.6)}
IDEAS = {
    "easy": (  # two springs, released; one that is released only oscillates along itself
        Idea(KIND, CENTRAL, 0.5),
        Idea(KIND, {"springs": Count(2, 2), "damping?": 0.0, "launch?": 0.0}),
        Idea(PLANE, {**ROUGH, "angle": Range(10.0, 30.0)}, 1.5),
    ),
    "medium": (
        Idea(KIND, {**EVEN, "springs": Count(2, 2), "damping?": 0.0, "launch?": 0.7}),
        Idea(KIND, {**EVEN, **CENTRAL}, 0.5),
        Idea(PLANE, {**ROUGH, "angle": Range(10.0, 40.0)}, 1.5),
    ),
    "hard": (  # friction of the springs themselves
        Idea(KIND, {**EVEN, "springs": Count(3, 3), "damping?": 0.6, "damping": Range(2.0, 8.0), "launch?": 0.6}, 2.0),
        Idea(KIND, {**EVEN, **CENTRAL}, 0.5),
        Idea(PLANE, {**ROUGH, "angle": Range(10.0, 60.0)}, 1.5),
    ),
}


@recipe("springs", share=2)
def draw_springs(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A block on a smooth table that several springs pull from different sides, or on a rough plane at one spring."""
    return one_of(IDEAS[difficulty], rng, "springs")
