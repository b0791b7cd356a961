"""Random scenes that have an equilibrium position."""

from collections.abc import Iterator

from sim2reason.errors import SceneError
from sim2reason.generation.item_search import generator
from sim2reason.generation.recipes import RECIPES
from sim2reason.simulation.equilibrium import Equilibrium, equilibrium

RESTFUL = ("chain", "mixed", "rolling", "rotation", "springs")
"""The recipes that have such scenes."""
SCENES = 12


def rests(recipe: str) -> Iterator[Equilibrium]:
    """Return the equilibria of some medium scenes of a recipe."""
    for index in range(SCENES):
        try:
            scene = RECIPES[recipe]("medium", generator(recipe, "medium", "numeric", 5, index, 0))
        except SceneError:
            continue
        rest = equilibrium(scene.mechanism)
        if rest is not None:
            yield rest
