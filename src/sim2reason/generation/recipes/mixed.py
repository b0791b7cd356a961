"""Entities of different families joined by connections: springs, pendulums, rolling bodies, pulleys, planes."""

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.parts.grow import Tier, grow
from sim2reason.generation.recipes.parts.ranges import NUMBERS, SIZES, WORDS
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.scene import Scene

SPRINGS = {"AnchoredSpring": 1.5, "SpringMassIncline": 1.5}
MACHINES = {"MassWithFixedPulley": 1.0, "TwoSideMassPlane": 0.7}
LOADS = {"HangingMass": 2.0, "ConstantForcePuller": 1.0}
SIMPLE = {
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
TIERS = {
    "easy": Tier(
        Count(2, 2),
        ({**SPRINGS, "RollingEntity": 1.0}, MACHINES),
        {**NUMBERS["easy"], **SIMPLE},
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
        {**NUMBERS["medium"], **SIMPLE},
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
        {**NUMBERS["hard"], **SIMPLE, "Hemisphere.mass": Range(1.0, 4.0), "SphericalCap.mass": Range(1.0, 3.5)},
        connections={"tendon": 1.0, "pivot": 1.0, "spring": 0.6},
        closers={**LOADS, "FixedSupport": 1.0},
        rough=0.3,
        more=0.4,
        words=WORDS["hard"],
    ),
}


# lengths of rods do not bear on the start; most periods are those of one spring and all masses; much takes a computer
WEIGHTS = {
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


@recipe("mixed", weights=WEIGHTS)
def draw_mixed(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Two entities of different families, joined by strings, hinges and springs."""
    return grow(TIERS[difficulty], rng)
