"""Oscillators: pendulums, and bodies held or joined by springs."""

from itertools import permutations
from math import cos, radians, sin, tan

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.growth import Tier, grow
from sim2reason.generation.recipes.ranges import NUMBERS, WORDS, Idea, draw_idea
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.mechanism import GRAVITY
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum
from sim2reason.scenes.entities.spring_blocks import SpringBlock, SpringMassIncline

PENDULUM = "Pendulum"
SLACKENING_RANGE = 2.0, 5.0
"""The squares of speeds at the lowest point, in units of gℓ, between which a string goes slack on the way up."""
RELEASED = {"bob.mass": Range(0.1, 10.0), "angle": Range(20.0, 90.0)}
SENT = {**RELEASED, "angle": Range(15.0, 60.0), "speed?": 1.0}


def _goes_slack(drawn: Pendulum) -> bool:
    """Return whether the string of a pendulum goes slack before the highest point of the circle."""
    rise = 1.0 - cos(radians(drawn.angle))
    square = (drawn.speed or 0.0) ** 2 / (GRAVITY * drawn.hanger.length) + 2.0 * rise
    return SLACKENING_RANGE[0] < square < SLACKENING_RANGE[1]


PENDULUM_IDEAS = {
    "easy": (  # released, or set moving: of a release energy alone tells most of what is not about time
        Idea(PENDULUM, {**RELEASED, "speed?": 0.0}),
        Idea(PENDULUM, {**RELEASED, "speed?": 1.0}, 2.0),
    ),
    "medium": (  # set moving from its lowest point or from the side, still less than half a turn to either side
        Idea(PENDULUM, {**SENT, "angle": 0.0, "speed": Range(0.5, 2.8)}),
        Idea(PENDULUM, {**SENT, "speed": Range(0.5, 2.5)}),
    ),
    "hard": (  # a string goes slack on the way up: nearly all about a full circle is one law
        Idea(PENDULUM, {**SENT, "angle": 0.0, "speed": Range(3.5, 9.0), "hanger": ("Cord",)}, 2.0, suits=_goes_slack),
        Idea(PENDULUM, {**SENT, "speed": Range(3.0, 9.0), "hanger": ("Cord",)}, 1.0, suits=_goes_slack),
    ),
}


CARRIED: dict[Difficulty, float] = {"medium": 0.5, "hard": 0.35}
"""The chance that the pendulum hangs from a carriage, which moves as it swings."""
PUSHED: dict[Difficulty, float] = {"medium": 0.0, "hard": 0.6}
PENDULUM_TIERS = {
    level: Tier(
        Count(2, 2),
        ({"SliderMass": 1.0}, {"LightRodPendulum": 1.0}),
        {**NUMBERS[level], "angle": Range(20.0, 80.0), "LightRod.length": Range(0.4, 1.5), "speed?": pushed},
        connections={"pivot": 1.0},
        more=0.0,
        words=WORDS[level],
    )
    for level, pushed in PUSHED.items()
}


# where a bob is at a time, and when it is somewhere, takes elliptic functions
PENDULUM_WEIGHTS = {
    "start": 0.1,
    "event": 0.6,
    "sum": 0.1,
    "state": 0.1,
    "time_to_event": 0.1,
    "period": 0.2,
    "comparison": 0.1,
    "threshold": 0.0,
    "optimum": 0.0,
    "numeric.period": 0.0,
}


@recipe("pendulum", share=2, weights=PENDULUM_WEIGHTS)
def draw_pendulum(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A bob on a string or light rod, perhaps on a carriage: released, launched, or fast enough to go slack."""
    if rng.random() < CARRIED.get(difficulty, 0.0):
        return grow(PENDULUM_TIERS[difficulty], rng)
    return draw_idea(PENDULUM_IDEAS[difficulty], rng, "pendulum")


ON_TABLE, ON_PLANE = "SpringBlock", "SpringMassIncline"
FAR_FROM_NAIL = {"SpringBlock.x": Range(0.25, 0.8), "SpringBlock.y": 0.0}  # from the nail at the origin
# one spring from the origin: energy and angular momentum are kept
CENTRAL = {
    "springs": Count(1, 1),
    "NailedSpring.x": 0.0,
    "NailedSpring.y": 0.0,
    "damping?": 0.0,
    "launch?": 1.0,
    **FAR_FROM_NAIL,
}
ACROSS = {**CENTRAL, "Launch.x": 0.0}  # launched at right angles to the spring
COMPARABLE_SPRINGS = {"stiffness": Range(50.0, 200.0)}  # comparable values, so that all matter
ROUGH_PLANE = {
    "stiffness": Range(40.0, 160.0),
    "mass": Range(0.5, 2.0),
    "friction": Range(0.25, 0.6),
}
MIN_STRAIN = 0.07  # of the natural length: smallest initial strain, for good conditioning
MIN_DRIVING_FORCE = 0.25  # of the block's weight: smallest initial driving force; less soon leaves it at rest
MIN_TANGENT_DEVIATION = 0.18  # smallest |tan θ − 1|, so that confusing sine and cosine changes the answer
MIN_NAIL_CLEARANCE = 0.08  # m, from a spring to the nail of another one


def _starts_well(entity: SpringMassIncline) -> bool:
    """Return whether the spring of a block on a rough plane is strained enough to set it in motion."""
    strain, angle = entity.start - entity.spring.length, radians(entity.plane.angle)
    pull = entity.spring.stiffness * strain / (GRAVITY * entity.block.mass) + sin(angle)  # down the slope
    moves = abs(pull) - entity.plane.friction * cos(angle) >= MIN_DRIVING_FORCE
    return moves and abs(strain) >= MIN_STRAIN * entity.spring.length and abs(tan(angle) - 1.0) >= MIN_TANGENT_DEVIATION


def _springs_clear_nails(entity: SpringBlock) -> bool:
    """Return whether every spring is clear of the nails of the others."""
    block = complex(entity.x, entity.y)
    nails = [complex(spring.x, spring.y) - block for spring in entity.springs]
    return all(_distance(other, nail) > MIN_NAIL_CLEARANCE for nail, other in permutations(nails, 2))


def _distance(point: complex, end: complex) -> float:
    """Return the distance, m, from a point to the segment between the block and a nail."""
    share = (point / end).real
    return abs(point - min(max(share, 0.0), 1.0) * end)


SPRING_IDEAS = {
    "easy": (  # two springs, released; one that is released only oscillates along itself
        Idea(ON_TABLE, ACROSS, 0.8),
        Idea(ON_TABLE, CENTRAL, 0.4),
        Idea(
            ON_TABLE, {"springs": Count(2, 2), "damping?": 0.0, "launch?": 0.0}, 0.1, _springs_clear_nails
        ),  # it needs integrating
        Idea(ON_PLANE, {**ROUGH_PLANE, "angle": Range(26.0, 38.0)}, 1.0, _starts_well),
    ),
    "medium": (
        Idea(
            ON_TABLE,
            {**COMPARABLE_SPRINGS, "springs": Count(2, 2), "damping?": 0.0, "launch?": 0.7},
            0.1,
            _springs_clear_nails,
        ),
        Idea(ON_TABLE, {**COMPARABLE_SPRINGS, **ACROSS}, 0.6),
        Idea(ON_TABLE, {**COMPARABLE_SPRINGS, **CENTRAL}, 0.6),
        Idea(ON_PLANE, {**ROUGH_PLANE, "angle": Range(30.0, 40.0)}, 1.2, _starts_well),
    ),
    "hard": (  # friction of the springs themselves
        Idea(
            ON_TABLE,
            {**COMPARABLE_SPRINGS, "springs": Count(3, 3), "damping?": 0.6, "damping": Range(2.0, 8.0), "launch?": 0.6},
            0.05,
            _springs_clear_nails,
        ),
        Idea(ON_PLANE, {**ROUGH_PLANE, "angle": Range(30.0, 60.0)}, 1.5, _starts_well),
    ),
}


# where springs pull from several sides, what adds up on the way, and when it is there, takes an integration
SPRING_WEIGHTS = {
    "start": 0.05,
    "state": 0.3,
    "event": 0.2,
    "time_to_event": 0.8,
    "sum": 0.05,
    "comparison": 0.05,
    "optimum": 0.0,
    "numeric.event": 0.1,
    "numeric.start": 0.0,
    "symbolic.extremum": 0.3,
}


@recipe("springs", share=2, weights=SPRING_WEIGHTS)
def draw_springs(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A block on a smooth table held by several springs at angles, or on a rough plane at one spring."""
    return draw_idea(SPRING_IDEAS[difficulty], rng, "springs")


CHAIN, RING = "SpringMassChain", "SpringMassRing"
COMPARABLE_CARTS = {"stiffness": Range(40.0, 160.0), "mass": Range(0.5, 2.0)}  # so that each of them counts
LEVEL_TRACK = {**COMPARABLE_CARTS, "Cart.mass": Range(1.0, 5.0), "angle?": 0.0, "friction?": 0.0, "damping?": 0.0}
CHAIN_IDEAS = {
    "easy": (  # one cart on one or two springs, or two carts on one
        Idea(CHAIN, {**LEVEL_TRACK, "carts": Count(1, 1), "ends": ("left", "right", "both")}),
        Idea(CHAIN, {**LEVEL_TRACK, "carts": Count(2, 2), "ends": ("free",)}),
    ),
    "medium": (  # two modes, a slope, or friction
        Idea(CHAIN, {**LEVEL_TRACK, "carts": Count(2, 2), "ends": ("left", "right", "both")}, 2.0),
        Idea(CHAIN, {**LEVEL_TRACK, "carts": Count(1, 2), "ends": ("left", "right"), "angle?": 1.0}),
        Idea(CHAIN, {**LEVEL_TRACK, "carts": Count(1, 1), "ends": ("left", "right"), "friction?": 1.0}),
        Idea(RING, {**COMPARABLE_CARTS, "beads": Count(2, 2), "damping?": 0.0}, 0.1),
    ),
    "hard": (
        Idea(CHAIN, {**LEVEL_TRACK, "carts": Count(2, 2), "ends": ("left", "right", "both"), "angle?": 1.0}, 2.0),
        Idea(
            CHAIN, {**LEVEL_TRACK, "carts": Count(3, 3), "ends": ("free",)}, 0.2
        ),  # two modes beside the common motion
        Idea(CHAIN, {**LEVEL_TRACK, "carts": Count(3, 3)}, 0.3),  # most questions about three modes need a computer
        Idea(CHAIN, {**LEVEL_TRACK, "carts": Count(2, 3), "damping?": 1.0}, 0.1),
        Idea(CHAIN, {**LEVEL_TRACK, "carts": Count(2, 2), "friction?": 1.0}),
        Idea(CHAIN, {**LEVEL_TRACK, "carts": Count(1, 1), "friction?": 1.0, "angle?": 1.0}, 1.5),
        Idea(RING, {**COMPARABLE_CARTS, "beads": Count(3, 3)}, 0.05),
    ),
}


# a blow bears on neither a period nor a start, nor does every spring on both; moments of two modes take a computer
CHAIN_WEIGHTS = {
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


@recipe("chain", weights=CHAIN_WEIGHTS)
def draw_chain(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Carts on a track, or beads on a ring, joined by springs: struck, or released with a strained spring."""
    return draw_idea(CHAIN_IDEAS[difficulty], rng, "chain")
