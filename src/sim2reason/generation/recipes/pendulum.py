"""Pendulums on rods and strings, at fixed points and on carriages."""

from math import cos, radians

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.parts.grow import Tier, grow
from sim2reason.generation.recipes.parts.ideas import Idea, one_of
from sim2reason.generation.recipes.parts.ranges import NUMBERS, WORDS
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.authoring import GRAVITY
from sim2reason.scenes.dsl.measures import Count, Range
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum

KIND = "Pendulum"
SLACKENS = 2.0, 5.0
"""The squares of speeds at the lowest point, in units of gℓ, between which a string goes slack on the way up."""
RELEASED = {"bob.mass": Range(0.1, 10.0), "angle": Range(20.0, 90.0)}
SENT = {**RELEASED, "angle": Range(15.0, 60.0), "speed?": 1.0}


def _goes_slack(drawn: Pendulum) -> bool:
    """Return whether the string of a pendulum goes slack before the highest point of the circle."""
    rise = 1.0 - cos(radians(drawn.angle))
    square = (drawn.speed or 0.0) ** 2 / (GRAVITY * drawn.hanger.length) + 2.0 * rise
    return SLACKENS[0] < square < SLACKENS[1]


IDEAS = {
    "easy": (  # released, or set moving: of a release energy alone tells most of what is not about time
        Idea(KIND, {**RELEASED, "speed?": 0.0}),
        Idea(KIND, {**RELEASED, "speed?": 1.0}, 2.0),
    ),
    "medium": (  # set moving from its lowest point or from the side, still less than half a turn to either side
        Idea(KIND, {**SENT, "angle": 0.0, "speed": Range(0.5, 2.8)}),
        Idea(KIND, {**SENT, "speed": Range(0.5, 2.5)}),
    ),
    "hard": (  # a string goes slack on the way up: nearly all about a full circle is one law
        Idea(KIND, {**SENT, "angle": 0.0, "speed": Range(3.5, 9.0), "hanger": ("Cord",)}, 2.0, suits=_goes_slack),
        Idea(KIND, {**SENT, "speed": Range(3.0, 9.0), "hanger": ("Cord",)}, 1.0, suits=_goes_slack),
    ),
}


CARRIED: dict[Difficulty, float] = {"medium": 0.5, "hard": 0.35}
"""The chance that the pendulum hangs from a carriage, which moves as it swings."""
PUSHED: dict[Difficulty, float] = {"medium": 0.0, "hard": 0.6}
TIERS = {
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
WEIGHTS = {
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


@recipe("pendulum", share=2, weights=WEIGHTS)
def draw_pendulum(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A bob on a string or light rod, perhaps on a carriage: released, launched, or fast enough to go slack."""
    if rng.random() < CARRIED.get(difficulty, 0.0):
        return grow(TIERS[difficulty], rng)
    return one_of(IDEAS[difficulty], rng, "pendulum")
