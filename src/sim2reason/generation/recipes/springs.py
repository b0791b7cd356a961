"""A puck on a table, held by springs at angles, and a block on a rough plane at the end of one spring."""

from itertools import permutations
from math import cos, radians, sin, tan

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.parts.ideas import Idea, one_of
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.mechanism import GRAVITY
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.spring_blocks import SpringBlock, SpringMassIncline

KIND, PLANE = "SpringBlock", "SpringMassIncline"
FAR = {"SpringBlock.x": Range(0.25, 0.8), "SpringBlock.y": 0.0}  # from the nail at the origin
# one spring from the origin: energy and angular momentum are kept
CENTRAL = {"springs": Count(1, 1), "NailedSpring.x": 0.0, "NailedSpring.y": 0.0, "damping?": 0.0, "launch?": 1.0, **FAR}
ACROSS = {**CENTRAL, "Launch.x": 0.0}  # launched at right angles to the spring
EVEN = {"stiffness": Range(50.0, 200.0)}  # comparable values, so that all matter
ROUGH = {
    "stiffness": Range(40.0, 160.0),
    "mass": Range(0.5, 2.0),
    "friction": Range(0.25, 0.6),
}
STRAINED = 0.07  # of the natural length: smallest initial strain, for good conditioning
DRIVEN = 0.25  # of the block's weight: smallest initial driving force; less soon leaves it at rest
UNLIKE = 0.18  # smallest |tan θ − 1|, so that confusing sine and cosine changes the answer
CLEAR = 0.08  # m, from a spring to the nail of another one


def _starts_well(held: SpringMassIncline) -> bool:
    """Return whether the spring of a block on a rough plane is strained enough to set it in motion."""
    strain, angle = held.start - held.spring.length, radians(held.plane.angle)
    pull = held.spring.stiffness * strain / (GRAVITY * held.block.mass) + sin(angle)  # down the slope
    moves = abs(pull) - held.plane.friction * cos(angle) >= DRIVEN
    return moves and abs(strain) >= STRAINED * held.spring.length and abs(tan(angle) - 1.0) >= UNLIKE


def _apart(held: SpringBlock) -> bool:
    """Return whether every spring is clear of the nails of the others."""
    block = complex(held.x, held.y)
    nails = [complex(spring.x, spring.y) - block for spring in held.springs]
    return all(_distance(other, nail) > CLEAR for nail, other in permutations(nails, 2))


def _distance(point: complex, end: complex) -> float:
    """Return the distance, m, from a point to the segment between the block and a nail."""
    share = (point / end).real
    return abs(point - min(max(share, 0.0), 1.0) * end)


IDEAS = {
    "easy": (  # two springs, released; one that is released only oscillates along itself
        Idea(KIND, ACROSS, 0.8),
        Idea(KIND, CENTRAL, 0.4),
        Idea(KIND, {"springs": Count(2, 2), "damping?": 0.0, "launch?": 0.0}, 0.1, _apart),  # it needs integrating
        Idea(PLANE, {**ROUGH, "angle": Range(26.0, 38.0)}, 1.0, _starts_well),
    ),
    "medium": (
        Idea(KIND, {**EVEN, "springs": Count(2, 2), "damping?": 0.0, "launch?": 0.7}, 0.1, _apart),
        Idea(KIND, {**EVEN, **ACROSS}, 0.6),
        Idea(KIND, {**EVEN, **CENTRAL}, 0.6),
        Idea(PLANE, {**ROUGH, "angle": Range(30.0, 40.0)}, 1.2, _starts_well),
    ),
    "hard": (  # friction of the springs themselves
        Idea(
            KIND,
            {**EVEN, "springs": Count(3, 3), "damping?": 0.6, "damping": Range(2.0, 8.0), "launch?": 0.6},
            0.05,
            _apart,
        ),
        Idea(PLANE, {**ROUGH, "angle": Range(30.0, 60.0)}, 1.5, _starts_well),
    ),
}


# where springs pull from several sides, what adds up on the way, and when it is there, takes an integration
WEIGHTS = {
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


@recipe("springs", share=2, weights=WEIGHTS)
def draw_springs(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A block on a smooth table held by several springs at angles, or on a rough plane at one spring."""
    return one_of(IDEAS[difficulty], rng, "springs")
