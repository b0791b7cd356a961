"""Planes and prisms joined to pulleys of both kinds."""

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.parts.grow import Tier, grow
from sim2reason.generation.recipes.parts.ranges import NUMBERS, PRISM, TWO, WORDS
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.measures import Count
from sim2reason.scenes.dsl.scene import Scene

MOVABLE = "MassWithMovablePulley"
PULLEYS = {"MassWithFixedPulley": 1.5, MOVABLE: 1.0, "MassWithReverseMovablePulley": 1.0}
RAMP = {"TwoSideMassPlane": 1.5}
FACES = {**RAMP, "MassPrismPlane": 2.5}
SIDES = dict.fromkeys((f"{MOVABLE}.left", f"{MOVABLE}.right"), ("Hanging", "OnPlane"))  # more would be too long to tell
TIERS = {
    "easy": Tier(  # a load over a light pulley, most often by a rough slope: anything more would be too long to tell
        Count(2, 2),
        ({"MassWithFixedPulley": 1.0}, RAMP),
        {**NUMBERS["easy"], "MassWithFixedPulley.system": ("Hanging",)},
        spread=4.0,
        rough=0.8,
        massive=0.0,
        more=0.0,
        words=WORDS["easy"] + TWO,
    ),
    "medium": Tier(
        Count(2, 2),
        (PULLEYS, FACES),
        {**NUMBERS["medium"], **SIDES},
        spread=4.0,
        rough=0.3,
        more=0.0,
        words=WORDS["medium"] + PRISM,
    ),
    "hard": Tier(
        Count(2, 2),
        (PULLEYS, FACES),
        {**NUMBERS["hard"], **SIDES},
        rough=0.6,
        massive=0.25,
        more=0.0,
        words=WORDS["hard"],
    ),
}


WEIGHTS = {
    "sum": 0.1,
    "start": 2.0,
    "state": 0.2,
    "time_to_event": 0.6,
    "threshold": 0.6,
    "comparison": 0.4,
    "optimum": 0.1,
    "extremum": 0.2,
    "limit": 0.3,
}


@recipe("hybrid", weights=WEIGHTS)
def draw_hybrid(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Two or three entities with pulleys and with planes, joined by strings."""
    return grow(TIERS[difficulty], rng)
