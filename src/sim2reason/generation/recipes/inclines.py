"""Blocks on planes, wedges, prisms and boxes."""

from dataclasses import replace

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.growth import Tier, grow
from sim2reason.generation.recipes.ranges import NUMBERS, SECOND_BODY_WORDS, WORDS
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
INCLINE_TIERS = {
    "easy": Tier(
        Count(1, 1),
        SIMPLE,
        {**NUMBERS["easy"], **ON_FACES},
        ALONE,
        spread=4.0,
        rough=0.5,
        more=0.3,
        words=WORDS["easy"] + SECOND_BODY_WORDS,
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
PULLED_FRACTION = 0.4  # fraction of easy scenes with two blocks pulled by a hand; otherwise they would slide as one
PAIR = replace(
    INCLINE_TIERS["easy"],
    choices={**NUMBERS["easy"], "system": ("OnPlane",), "blocks": Count(2, 2)},
    alone={"speed?": 0.0},
    closers={"ConstantForcePuller": 1.0},
    more=0.6,
)

INCLINE_WEIGHTS = {
    "start": 0.5,  # of a lone block no more than its forces
    "threshold": 0.3,
    "extremum": 0.1,
    "optimum": 0.1,
    "limit": 0.3,
    "state": 0.2,
    "sum": 0.5,
}


@recipe("incline", weights=INCLINE_WEIGHTS)
def draw_incline(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """One to three entities with faces, joined by strings."""
    pulled = difficulty == "easy" and rng.random() < PULLED_FRACTION
    return grow(PAIR if pulled else INCLINE_TIERS[difficulty], rng)


BOXES = ({"MassBoxPlane": 2.0, "MassPrismPlane": 1.0},)
PULLED_BY_HAND = {"ConstantForcePuller": 1.0}
PULLED_BY_LOAD = {"ConstantForcePuller": 1.0, "HangingMass": 1.0}
BOX_SIZES = {"left_angle": Range(15.0, 75.0), "right_angle": Range(15.0, 75.0)}
ONE_BLOCK = {"blocks": Count(1, 1), "left_blocks": Count(1, 1), "right_blocks": Count(1, 1)}
BOX_TIERS = {
    "easy": Tier(
        Count(1, 1),
        BOXES,
        {**NUMBERS["easy"], **BOX_SIZES, **ONE_BLOCK, "left?": 0.0},
        closers=PULLED_BY_HAND,
        spread=4.0,
        more=0.3,
        words=WORDS["medium"],
    ),
    "medium": Tier(
        Count(1, 1),
        BOXES,
        {**NUMBERS["medium"], **BOX_SIZES, **ONE_BLOCK, "left?": 0.6},
        closers=PULLED_BY_HAND,
        spread=4.0,
        rough=0.5,
        more=0.3,
        words=WORDS["medium"] + 30,
    ),
    "hard": Tier(
        Count(1, 1),
        BOXES,
        {**NUMBERS["hard"], **BOX_SIZES, "left?": 0.6, "blocks": Count(1, 2)},
        closers=PULLED_BY_LOAD,
        rough=0.8,
        more=0.25,
        words=WORDS["hard"],
    ),
}


BOX_WEIGHTS = {
    "threshold": 1.0,
    "start": 2.0,
    "state": 0.2,
    "time_to_event": 0.6,
    "limit": 0.3,
    "optimum": 0.0,
}


@recipe("box", weights=BOX_WEIGHTS)
def draw_box(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A large movable body with other bodies on it, often pulled by a hand or a hanging load."""
    return grow(BOX_TIERS[difficulty], rng)
