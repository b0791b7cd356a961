"""Horses of three strengths."""

import numpy as np

from sim2reason.dsl.entity import Named
from sim2reason.dsl.measures import Range
from sim2reason.dsl.model import draw
from sim2reason.dsl.scene import Scene
from sim2reason.recipes import Difficulty, recipe
from sledges.horse_and_sledge import HorseAndSledge

FORCE = {"easy": Range(5.0, 10.0), "medium": Range(5.0, 50.0), "hard": Range(5.0, 100.0)}


@recipe("sledges")
def draw_sledges(difficulty: Difficulty, rng: np.random.Generator) -> Scene:
    """A sledge, and a horse whose force may be greater the harder it is."""
    sledge = draw(HorseAndSledge, rng, {"draught": FORCE[difficulty]})
    return Scene(entities=(Named(name="sledge", entity=sledge),))
