"""Strings over pulleys: with hanging masses, planes and prisms, or entities of other families."""

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.growth import Tier, grow
from sim2reason.generation.recipes.ranges import NUMBERS, PRISM_WORDS, SECOND_BODY_WORDS, SIZES, WORDS
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.scene import Scene

MOVABLE = "MassWithMovablePulley"
MOVABLE_WORDS = 7  # additional words to describe a movable pulley
PULLEY_POOL = (
    {"MassWithFixedPulley": 2.0},
    {MOVABLE: 1.5, "MassWithReverseMovablePulley": 1.5},
)  # else it were a chain
SYSTEMS = ("MassWithFixedPulley.system", f"{MOVABLE}.left", f"{MOVABLE}.right")
HANGING = dict.fromkeys(SYSTEMS, ("Hanging",))
STANDING = dict.fromkeys(SYSTEMS, ("Hanging", "OnPlane"))  # strings to wedges take more words than a reader holds
PULLEY_TIERS = {
    "easy": Tier(
        Count(2, 2),
        ({"MassWithFixedPulley": 2.0}, {MOVABLE: 0.5, "MassWithReverseMovablePulley": 3.0}),
        {**NUMBERS["easy"], **HANGING},
        spread=4.0,
        massive=0.25,
        words=WORDS["easy"] + SECOND_BODY_WORDS + MOVABLE_WORDS,
    ),
    "medium": Tier(
        Count(2, 3),
        PULLEY_POOL,
        {**NUMBERS["medium"], **HANGING, SYSTEMS[0]: ("Hanging", "OnPlane")},
        spread=4.0,
        massive=0.4,
        words=WORDS["medium"],
    ),
    "hard": Tier(
        Count(2, 3), PULLEY_POOL, {**NUMBERS["hard"], **STANDING}, rough=0.4, massive=0.4, words=WORDS["hard"]
    ),
}


PULLEY_WEIGHTS = {
    "threshold": 0.5,
    "start": 2.0,
    "state": 0.2,
    "time_to_event": 0.6,
    "extremum": 0.2,
    "optimum": 0.0,
}


@recipe("pulley", weights=PULLEY_WEIGHTS)
def draw_pulley(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Two or three pulley entities joined by strings."""
    return grow(PULLEY_TIERS[difficulty], rng)


PULLEYS = {"MassWithFixedPulley": 1.5, MOVABLE: 1.0, "MassWithReverseMovablePulley": 1.0}
RAMP = {"TwoSideMassPlane": 1.5}
FACES = {**RAMP, "MassPrismPlane": 2.5}
SIDES = dict.fromkeys((f"{MOVABLE}.left", f"{MOVABLE}.right"), ("Hanging", "OnPlane"))  # more would be too long to tell
HYBRID_TIERS = {
    "easy": Tier(  # a load over a light pulley, most often by a rough slope: anything more would be too long to tell
        Count(2, 2),
        ({"MassWithFixedPulley": 1.0}, RAMP),
        {**NUMBERS["easy"], "MassWithFixedPulley.system": ("Hanging",)},
        spread=4.0,
        rough=0.8,
        massive=0.0,
        more=0.0,
        words=WORDS["easy"] + SECOND_BODY_WORDS,
    ),
    "medium": Tier(
        Count(2, 2),
        (PULLEYS, FACES),
        {**NUMBERS["medium"], **SIDES},
        spread=4.0,
        rough=0.3,
        more=0.0,
        words=WORDS["medium"] + PRISM_WORDS,
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


HYBRID_WEIGHTS = {
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


@recipe("hybrid", weights=HYBRID_WEIGHTS)
def draw_hybrid(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Two or three entities with pulleys and with planes, joined by strings."""
    return grow(HYBRID_TIERS[difficulty], rng)


SPRINGS = {"AnchoredSpring": 1.5, "SpringMassIncline": 1.5}
MACHINES = {"MassWithFixedPulley": 1.0, "TwoSideMassPlane": 0.7}
LOADS = {"HangingMass": 2.0, "ConstantForcePuller": 1.0}
SIMPLE_PARTS = {
    "MassWithFixedPulley.system": ("Hanging",),
    "blocks": Count(1, 1),
    "RollingEntity.body": ("Sphere", "SphericalShell", "Roller", "Disc", "Hoop"),
    "grip": ("NoSlipping",),
    "start?": 0.0,
    "pieces": Count(1, 1),
    "angle": Range(10.0, 60.0),
    **SIZES,
    "radius": Range(0.06, 0.1),
    "height": Range(0.15, 0.3),
    "SphericalCap.height": Range(0.05, 0.11),
    "distance": Range(0.1, 0.4),
}
MIXED_TIERS = {
    "easy": Tier(
        Count(2, 2),
        ({**SPRINGS, "RollingEntity": 1.0}, MACHINES),
        {**NUMBERS["easy"], **SIMPLE_PARTS},
        closers=LOADS,
        spread=4.0,
        more=0.1,
        words=WORDS["medium"],
    ),
    "medium": Tier(  # a coupling: a pendulum on a carriage, a block that two strings hold at angles; or more loads
        Count(2, 2),
        (
            {"SliderMass": 1.0, "DirectedMass": 1.0, "RollingEntity": 0.6, "SpringMassIncline": 1.0},
            {"LightRodPendulum": 1.0, **MACHINES},
        ),
        {**NUMBERS["medium"], **SIMPLE_PARTS},
        connections={"tendon": 1.0, "pivot": 1.0},
        closers=LOADS,
        spread=4.0,
        more=0.3,
        words=WORDS["hard"],
    ),
    "hard": Tier(
        Count(2, 2),
        (
            {"SliderMass": 2.0, "RollingEntity": 1.5, "AnchoredSpring": 0.6, "SpringMassIncline": 0.6},
            {"RigidPendulum": 1.0, **MACHINES},
        ),
        {**NUMBERS["hard"], **SIMPLE_PARTS, "Hemisphere.mass": Range(1.0, 4.0), "SphericalCap.mass": Range(1.0, 3.5)},
        connections={"tendon": 1.0, "pivot": 1.0, "spring": 0.6},
        closers={**LOADS, "FixedSupport": 1.0},
        rough=0.3,
        more=0.4,
        words=WORDS["hard"],
    ),
}


# lengths of rods do not bear on the start; most periods are those of one spring and all masses; much takes a computer
MIXED_WEIGHTS = {
    "start": 0.6,
    "state": 0.3,
    "period": 0.2,
    "sum": 0.05,
    "extremum": 0.4,
    "comparison": 0.2,
    "equilibrium": 0.1,
    "threshold": 0.1,
    "limit": 0.1,
    "optimum": 0.0,
    "numeric.period": 0.1,
}


@recipe("mixed", weights=MIXED_WEIGHTS)
def draw_mixed(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Two entities of different families, joined by strings, hinges and springs."""
    return grow(MIXED_TIERS[difficulty], rng)
