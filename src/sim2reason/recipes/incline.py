"""Blocks on planes, wedges and prisms, smooth or rough."""

import numpy as np

from sim2reason.dsl.measures import Count
from sim2reason.dsl.scene import Scene
from sim2reason.recipes import Difficulty, recipe
from sim2reason.recipes.parts.grow import Tier, grow
from sim2reason.recipes.parts.ranges import NUMBERS, PRISM, WORDS

ON_FACES = {"system": ("OnPlane", "OnWedge", "OnWedge")}
SIMPLE = {"TwoSideMassPlane": 2.0, "MassPrismPlane": 1.5}
WIDE = {"TwoSideMassPlane": 2.0, "MassPrismPlane": 1.5, "MassWithFixedPulley": 1.5}
TIERS = {
    "easy": Tier(
        Count(1, 1),
        SIMPLE,
        {**NUMBERS["easy"], **ON_FACES},
        rough=0.3,
        more=0.3,
        speed=0.6,
        words=WORDS["easy"] + PRISM,
    ),
    "medium": Tier(
        Count(1, 2), WIDE, {**NUMBERS["medium"], **ON_FACES}, rough=0.4, more=0.3, speed=0.6, words=WORDS["medium"]
    ),
    "hard": Tier(Count(2, 3), WIDE, {**NUMBERS["hard"], **ON_FACES}, rough=0.7, more=0.4, words=WORDS["hard"]),
}


@recipe("incline")
def draw_incline(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """One to three entities with faces, joined by strings."""
    return grow(TIERS[difficulty], rng)
