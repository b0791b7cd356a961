"""A body that is held at the level of the mechanism is one that the builder never let move."""

import numpy as np
import pytest

from sim2reason.datasets.random_scenes import sample
from sim2reason.dsl.ablation import held
from sim2reason.errors import SceneError, SimulationError
from sim2reason.simulation.trace import ENGINES

RECIPES = ["pulley", "hybrid", "box", "incline", "mixed", "chain", "springs"]


@pytest.mark.parametrize("recipe", RECIPES)
@pytest.mark.parametrize("index", range(3))
def test_what_is_held_is_what_the_builder_glues(recipe: str, index: int) -> None:
    scene = sample(recipe, "medium", seed=5, index=index)
    mechanism = scene.mechanism
    massive = [body.name for body in mechanism.bodies if body.coordinates and body.mass and body.name in scene.bodies]
    turned = {wheel.coordinate for line in mechanism.lines if line.circle is None for wheel in line.wheels}
    for name in massive:
        if any(coordinate.name in turned for coordinate in mechanism.body[name].coordinates):
            continue  # the builder takes a glued pulley for a smooth one
        try:
            glued = scene.gluing(name).mechanism
        except SceneError:  # nothing is left that could move, or a welded body was told to move
            continue
        assert held(mechanism, name) == glued
        try:
            trace = ENGINES["exact"](glued, np.array([0.0, 0.1]))
        except SimulationError:
            continue
        assert np.isfinite(trace.state.q).all()
