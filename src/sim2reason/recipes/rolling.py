"""Round bodies that roll, slip till they roll, or rock, and prisms that tumble."""

import numpy as np

from sim2reason.dsl.measures import Range
from sim2reason.dsl.scene import Scene
from sim2reason.recipes import Difficulty, recipe
from sim2reason.recipes.parts.ideas import Idea, one_of

KIND, PRISM = "RollingEntity", "TumblingPrism"
CENTRED = ("Sphere", "HollowSphere", "SphericalShell", "Roller", "Pipe", "ThickPipe", "Disc", "Hoop")
HOLED = ("BoredCylinder", "SphereWithHole")
ROLLS = {"body": CENTRED, "grip": ("NoSlipping",), "way": ("up the slope", "down the slope"), "start": ("Rolling",)}
LEVEL = {"body": CENTRED, "grip": ("Rough",), "angle": 0.0, "start?": 1.0, "way": ("to the right",)}
ROCKS = {"body": HOLED, "hole?": 1.0, "grip": ("NoSlipping",), "bearing": Range(20.0, 160.0)}
IDEAS = {
    "easy": (
        Idea(KIND, {**ROLLS, "start?": 0.0}),
        Idea(KIND, {**ROLLS, "start?": 1.0}),
    ),
    "medium": (  # it slips until it rolls, slips all the way on too steep a slope, or has its weight on one side
        Idea(KIND, {**LEVEL, "start": ("Sliding", "Spinning")}, 2.0),
        Idea(KIND, {**ROLLS, "grip": ("Rough",), "start?": 0.3}),
        Idea(KIND, {**ROCKS, "angle": 0.0, "towards": ("right",)}, 2.0),
    ),
    "hard": (
        Idea(KIND, {**ROCKS, "towards": ("uphill", "downhill")}, 2.0),
        Idea(KIND, {**ROCKS, "grip": ("Rough",), "towards": ("uphill", "downhill")}, 2.0),
        Idea(KIND, {**ROLLS, "grip": ("Rough",), "start?": 1.0, "start": ("Sliding", "Spinning")}),
        Idea(
            PRISM,
            {"rate?": 1.0, "rate": Range(4.5, 6.0), "angle": Range(6.0, 12.0), "shape": ("octagonal", "decagonal")},
        ),
    ),
}


@recipe("rolling", share=2)
def draw_rolling(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A sphere, cylinder, hoop or prism on a plane, perhaps with a hole beside its axis."""
    return one_of(IDEAS[difficulty], rng, "roller")
