"""Blocks on planes, wedges and prisms, smooth or rough."""

from dataclasses import replace

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.parts.grow import Tier, grow
from sim2reason.generation.recipes.parts.ranges import NUMBERS, TWO, WORDS
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.scene import Scene

ON_FACES = {"system": ("OnPlane", "OnWedge", "OnWedge")}
SIMPLE = ({"TwoSideMassPlane": 1.0},)
WIDE = ({"TwoSideMassPlane": 2.0, "MassPrismPlane": 1.5, "MassWithFixedPulley": 1.5, "StackedMassPlane": 1.5},)
WIDEST = ({**WIDE[0], "MassPrismPlane": 4.0},)  # few of these have room for further entities
STACK = {"StackedMassPlane.friction": Range(0.1, 0.6), "top_friction": Range(0.1, 0.6), "StackedMassPlane.speed?": 0.3}
TALL = {**STACK, "top?": 0.25, "top_friction?": 0.4}
ALONE = {"speed?": 0.6}  # a plane without strings often starts with a speed
TIERS = {
    "easy": Tier(
        Count(1, 1),
        SIMPLE,
        {**NUMBERS["easy"], **ON_FACES},
        ALONE,
        spread=4.0,
        rough=0.5,
        more=0.3,
        words=WORDS["easy"] + TWO,
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
    "hard": Tier(
        Count(2, 2), WIDEST, {**NUMBERS["hard"], **ON_FACES, **TALL}, rough=0.7, more=0.8, words=WORDS["hard"]
    ),
}
PULLED = 0.4  # fraction of easy scenes with two blocks pulled by a hand; otherwise they would slide as one
PAIR = replace(
    TIERS["easy"],
    choices={**NUMBERS["easy"], "system": ("OnPlane",), "blocks": Count(2, 2)},
    alone={"speed?": 0.0},
    closers={"ConstantForcePuller": 1.0},
    more=0.6,
)

WEIGHTS = {
    "start": 0.5,  # of a lone block no more than its forces
    "threshold": 0.3,
    "extremum": 0.1,
    "optimum": 0.1,
    "limit": 0.3,
    "state": 0.2,
    "sum": 0.5,
}


@recipe("incline", weights=WEIGHTS)
def draw_incline(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """One to three entities with faces, joined by strings."""
    pulled = difficulty == "easy" and rng.random() < PULLED
    return grow(PAIR if pulled else TIERS[difficulty], rng)
