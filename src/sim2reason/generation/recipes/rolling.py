"""Round bodies that roll, slip before rolling, or rock, and prisms that tumble."""

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.generation.recipes.parts.ideas import Idea, one_of
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.measures import Range
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.rolling import RollingEntity

KIND, PRISM = "RollingEntity", "TumblingPrism"
CENTRED = ("Sphere", "SphericalShell", "Roller", "Pipe", "Disc", "Hoop")
ANY = (*CENTRED, "HollowSphere", "ThickPipe")  # the thickness of the wall matters if the body is set spinning
HOLED = ("BoredCylinder", "SphereWithHole")
ROLLS = {"body": CENTRED, "grip": ("NoSlipping",), "way": ("up the slope", "down the slope"), "start": ("Rolling",)}
LEVEL = {
    "body": ANY,
    "HollowSphere.thickness": Range(0.02, 0.04),
    "grip": ("Rough",),
    "angle": 0.0,
    "start?": 1.0,
    "way": ("to the right",),
}
ROCKS = {  # with a hole so large, a centre of mass so low, and on so gentle a slope, that it counts
    "body": HOLED,
    "hole?": 1.0,
    "towards?": 1.0,
    "grip": ("NoSlipping",),
    "bearing": Range(15.0, 60.0),
    "radius": Range(0.15, 0.2),
    "hole": Range(0.11, 0.15),
    "offset": Range(0.03, 0.055),
}
COUNTS = 1.22  # least ratio of the moments of inertia with and without the hole


def _hole_counts(entity: RollingEntity) -> bool:
    """Return whether omitting the hole from the moment of inertia changes the answer."""
    solid, plain = (held.inertia(1.0)[1] for held in (entity.body.solid, entity.body.plainer["hole"]))
    return solid >= COUNTS * plain


LIVELY = {
    **ROLLS,
    "grip": ("Rough",),
    "angle": Range(20.0, 42.0),
    "start?": 1.0,
    "start": ("Sliding", "Spinning", "Spinning"),
}
IDEAS = {
    "easy": (
        Idea(KIND, {**ROLLS, "start?": 0.0}),
        Idea(KIND, {**ROLLS, "start?": 1.0}),
    ),
    "medium": (  # it slips until it rolls, slips all the way on too steep a slope, or has its weight on one side
        Idea(KIND, {**LEVEL, "start": ("Sliding", "Spinning", "Spinning")}, 1.2),
        Idea(KIND, {**ROLLS, "grip": ("Rough",), "start?": 0.0}, 0.3),  # few questions about it take more than two laws
        Idea(KIND, {**ROCKS, "angle": 0.0, "towards": ("right",)}, 0.6, _hole_counts),
    ),
    "hard": (
        Idea(KIND, {**ROCKS, "angle": Range(2.0, 12.0), "towards": ("uphill", "downhill")}, 1.0, _hole_counts),
        Idea(KIND, LIVELY, 4.0),
        Idea(
            PRISM,
            {"rate?": 1.0, "rate": Range(4.5, 6.0), "angle": Range(6.0, 12.0), "shape": ("octagonal", "decagonal")},
            0.7,
        ),
    ),
}


# a period hangs neither on how it begins nor on the mass
WEIGHTS = {
    "start": 0.4,
    "period": 0.1,
    "extremum": 0.1,
    "limit": 0.1,
    "optimum": 0.1,
    "numeric.period": 0.0,
    "symbolic.optimum": 0.1,  # of formulas that are too long
}


@recipe("rolling", share=2, weights=WEIGHTS)
def draw_rolling(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A sphere, cylinder, hoop or prism on a plane, perhaps with a hole beside its axis."""
    return one_of(IDEAS[difficulty], rng, "roller")
