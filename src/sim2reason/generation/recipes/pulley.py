"""Masses on strings over fixed and movable pulleys."""

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.parts.grow import Tier, grow
from sim2reason.generation.recipes.parts.ranges import NUMBERS, TWO, WORDS
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.measures import Count
from sim2reason.scenes.dsl.scene import Scene

MOVABLE = "MassWithMovablePulley"
MOVABLE_WORDS = 7  # additional words to describe a movable pulley
POOL = ({"MassWithFixedPulley": 2.0}, {MOVABLE: 1.5, "MassWithReverseMovablePulley": 1.5})  # else it were a chain
SYSTEMS = ("MassWithFixedPulley.system", f"{MOVABLE}.left", f"{MOVABLE}.right")
HANGING = dict.fromkeys(SYSTEMS, ("Hanging",))
STANDING = dict.fromkeys(SYSTEMS, ("Hanging", "OnPlane"))  # strings to wedges take more words than a reader holds
TIERS = {
    "easy": Tier(
        Count(2, 2),
        ({"MassWithFixedPulley": 2.0}, {MOVABLE: 0.5, "MassWithReverseMovablePulley": 3.0}),
        {**NUMBERS["easy"], **HANGING},
        spread=4.0,
        massive=0.25,
        words=WORDS["easy"] + TWO + MOVABLE_WORDS,
    ),
    "medium": Tier(
        Count(2, 3),
        POOL,
        {**NUMBERS["medium"], **HANGING, SYSTEMS[0]: ("Hanging", "OnPlane")},
        spread=4.0,
        massive=0.4,
        words=WORDS["medium"],
    ),
    "hard": Tier(Count(2, 3), POOL, {**NUMBERS["hard"], **STANDING}, rough=0.4, massive=0.4, words=WORDS["hard"]),
}


WEIGHTS = {
    "threshold": 0.5,
    "start": 2.0,
    "state": 0.2,
    "time_to_event": 0.6,
    "extremum": 0.2,
    "optimum": 0.0,
}


@recipe("pulley", weights=WEIGHTS)
def draw_pulley(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Two or three pulley entities joined by strings."""
    return grow(TIERS[difficulty], rng)
