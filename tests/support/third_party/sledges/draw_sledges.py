"""Recipe of sledges with horses of three strengths."""

import numpy as np

from sim2reason.generation.recipes import recipe
from sim2reason.questions.difficulty import Difficulty
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.measures import Range
from sim2reason.scenes.dsl.model import draw
from sim2reason.scenes.dsl.scene import Scene
from sledges.horse_and_sledge import HorseAndSledge

FORCE = {"easy": Range(5.0, 10.0), "medium": Range(5.0, 50.0), "hard": Range(5.0, 100.0)}


@recipe("sledges")
def draw_sledges(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """Draw a sledge and a horse, whose force may be greater for harder problems."""
    sledge = draw(HorseAndSledge, rng, {"draught": FORCE[difficulty]})
    return Scene(entities=(Named(name="sledge", entity=sledge),))
