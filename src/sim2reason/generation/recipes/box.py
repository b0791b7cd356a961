"""Boxes and prisms that can slide, with blocks on their tops, sides and faces."""

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.parts.grow import Tier, grow
from sim2reason.generation.recipes.parts.ranges import NUMBERS, WORDS
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.scene import Scene

BOXES = ({"MassBoxPlane": 2.0, "MassPrismPlane": 1.0},)
DRAWN = {"ConstantForcePuller": 1.0}
HUNG = {"ConstantForcePuller": 1.0, "HangingMass": 1.0}
SIZES = {"left_angle": Range(15.0, 75.0), "right_angle": Range(15.0, 75.0)}
ONE = {"blocks": Count(1, 1), "left_blocks": Count(1, 1), "right_blocks": Count(1, 1)}
TIERS = {
    "easy": Tier(
        Count(1, 1),
        BOXES,
        {**NUMBERS["easy"], **SIZES, **ONE, "left?": 0.0},
        closers=DRAWN,
        spread=4.0,
        more=0.3,
        words=WORDS["medium"],
    ),
    "medium": Tier(
        Count(1, 1),
        BOXES,
        {**NUMBERS["medium"], **SIZES, **ONE, "left?": 0.6},
        closers=DRAWN,
        spread=4.0,
        rough=0.5,
        more=0.3,
        words=WORDS["medium"] + 30,
    ),
    "hard": Tier(
        Count(1, 1),
        BOXES,
        {**NUMBERS["hard"], **SIZES, "left?": 0.6, "blocks": Count(1, 2)},
        closers=HUNG,
        rough=0.8,
        more=0.25,
        words=WORDS["hard"],
    ),
}


WEIGHTS = {
    "threshold": 1.0,
    "start": 2.0,
    "state": 0.2,
    "time_to_event": 0.6,
    "limit": 0.3,
    "optimum": 0.0,
}


@recipe("box", weights=WEIGHTS)
def draw_box(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A large movable body with other bodies on it, often pulled by a hand or a hanging load."""
    return grow(TIERS[difficulty], rng)
