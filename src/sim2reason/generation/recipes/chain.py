"""Carts joined by springs in a row, and beads joined by springs in a ring."""

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.parts.ideas import Idea, one_of
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.scene import Scene

KIND, RING = "SpringMassChain", "SpringMassRing"
EVEN = {"stiffness": Range(40.0, 160.0), "mass": Range(0.5, 2.0)}  # so that each of them counts
LEVEL = {**EVEN, "Cart.mass": Range(1.0, 5.0), "angle?": 0.0, "friction?": 0.0, "damping?": 0.0}
IDEAS = {
    "easy": (  # one cart on one or two springs, or two carts on one
        Idea(KIND, {**LEVEL, "carts": Count(1, 1), "ends": ("left", "right", "both")}),
        Idea(KIND, {**LEVEL, "carts": Count(2, 2), "ends": ("free",)}),
    ),
    "medium": (  # two modes, a slope, or friction
        Idea(KIND, {**LEVEL, "carts": Count(2, 2), "ends": ("left", "right", "both")}, 2.0),
        Idea(KIND, {**LEVEL, "carts": Count(1, 2), "ends": ("left", "right"), "angle?": 1.0}),
        Idea(KIND, {**LEVEL, "carts": Count(1, 1), "ends": ("left", "right"), "friction?": 1.0}),
        Idea(RING, {**EVEN, "beads": Count(2, 2), "damping?": 0.0}, 0.1),
    ),
    "hard": (
        Idea(KIND, {**LEVEL, "carts": Count(2, 2), "ends": ("left", "right", "both"), "angle?": 1.0}, 2.0),
        Idea(KIND, {**LEVEL, "carts": Count(3, 3), "ends": ("free",)}, 0.2),  # two modes beside the common motion
        Idea(KIND, {**LEVEL, "carts": Count(3, 3)}, 0.3),  # most questions about three modes need a computer
        Idea(KIND, {**LEVEL, "carts": Count(2, 3), "damping?": 1.0}, 0.1),
        Idea(KIND, {**LEVEL, "carts": Count(2, 2), "friction?": 1.0}),
        Idea(KIND, {**LEVEL, "carts": Count(1, 1), "friction?": 1.0, "angle?": 1.0}, 1.5),
        Idea(RING, {**EVEN, "beads": Count(3, 3)}, 0.05),
    ),
}


# a blow bears on neither a period nor a start, nor does every spring on both; moments of two modes take a computer
WEIGHTS = {
    "period": 0.5,
    "start": 0.15,
    "comparison": 0.05,
    "event": 0.2,
    "sum": 0.1,
    "extremum": 0.25,
    "time_to_event": 0.2,
    "equilibrium": 0.2,
    "optimum": 0.0,
    "numeric.period": 0.3,
    "symbolic.comparison": 0.1,  # of formulas that are too long
}


@recipe("chain", weights=WEIGHTS)
def draw_chain(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Carts on a track, or beads on a ring, joined by springs: struck, or released with a strained spring."""
    return one_of(IDEAS[difficulty], rng, "chain")
