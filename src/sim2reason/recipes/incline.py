"""Blocks on planes, wedges and prisms, smooth or rough."""

import numpy as np

from sim2reason.dsl.measures import Count, Range
from sim2reason.dsl.scene import Scene
from sim2reason.recipes import Difficulty, recipe
from sim2reason.recipes.parts.grow import Tier, grow
from sim2reason.recipes.parts.ranges import NUMBERS, WORDS

ON_FACES = {"system": ("OnPlane", "OnWedge", "OnWedge")}
SIMPLE = ({"TwoSideMassPlane": 1.0},)
WIDE = ({"TwoSideMassPlane": 2.0, "MassPrismPlane": 1.5, "MassWithFixedPulley": 1.5, "StackedMassPlane": 1.5},)
STACK = {"StackedMassPlane.friction": Range(0.1, 0.6), "top_friction": Range(0.1, 0.6), "StackedMassPlane.speed?": 0.3}
TALL = {**STACK, "top?": 0.4, "top_friction?": 0.4}
ALONE = {"speed?": 0.6}  # a plane without strings often starts with a speed
TIERS = {
    "easy": Tier(
        Count(1, 1),
        SIMPLE,
        {**NUMBERS["easy"], **ON_FACES, "blocks": Count(1, 2)},
        ALONE,
        spread=4.0,
        rough=0.5,
        more=0.6,
        words=WORDS["easy"],
    ),
    "medium": Tier(
        Count(1, 2),
        WIDE,
        {**NUMBERS["medium"], **ON_FACES, **STACK},
        ALONE,
        spread=4.0,
        rough=0.4,
        more=0.3,
        words=WORDS["medium"],
    ),
    "hard": Tier(Count(2, 3), WIDE, {**NUMBERS["hard"], **ON_FACES, **TALL}, rough=0.7, more=0.4, words=WORDS["hard"]),
}


@recipe("incline")
def draw_incline(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """One to three entities with faces, joined by strings."""
    return grow(TIERS[difficulty], rng)
