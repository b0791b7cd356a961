"""Tests of bodies that are fixed in a finished mechanism."""

import numpy as np
import pytest

from plain_scenes import massive
from sim2reason.errors import SceneError, SimulationError
from sim2reason.generation.item_search import sample
from sim2reason.scenes.dsl.structure import fix_body
from sim2reason.simulation.quantities.kinematics import Velocity
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
            continue  # strings slide over a pulley that is glued, and stand still on one that is held
        try:
            glued = scene.gluing(name).mechanism
        except SceneError:  # nothing is left that could move, or a welded body was told to move
            continue
        assert fix_body(mechanism, name) == glued
        try:
            trace = ENGINES["exact"](glued, np.array([0.0, 0.1]))
        except SimulationError:
            continue
        assert np.isfinite(trace.state.q).all()


def test_strings_slide_over_a_glued_pulley_and_stand_still_on_one_that_is_held() -> None:
    """Blocks of 3 kg and 2 kg over a glued pulley accelerate with g/5, as over a light one."""
    scene = massive(2.0)
    name = next(wheel for wheel in scene.bodies if wheel.endswith("pulley") and scene.bodies[wheel].mass)  # type: ignore[attr-defined]
    block = "one.system.blocks.0"
    moved = []
    for mechanism in (scene.gluing(name).mechanism, fix_body(scene.mechanism, name)):
        state = ENGINES["exact"](mechanism, np.array([0.0, 0.1])).state
        moved.append(abs(float(Velocity.evaluate(state, block)[-1, 2])))
    assert moved == [pytest.approx(0.1 * 9.8 / 5.0), pytest.approx(0.0, abs=1e-9)]
