"""A motion that is continued to a longer duration is that of a new simulation, in every bit."""

from dataclasses import replace

import numpy as np
import pytest

from sim2reason.generation.item_search import sample
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X
from sim2reason.simulation.engines.exact import motion
from sim2reason.simulation.engines.exact.motion import Motion

RECIPES = ["pulley", "chain", "collision", "springs", "incline", "mixed", "pendulum", "box"]
SHARES = [0.05, 0.3, 0.3, 1.0, 0.5, 3.0]  # of a scene's own duration, in turn: longer, the same, shorter


def told(found: Motion) -> tuple[object, ...]:
    state = found.state(np.linspace(0.0, found.end, 25))
    forces = [*state.constraint_tension.values(), *state.normal.values(), *state.friction.values()]
    numbers = [array.tobytes() for array in (state.q, state.v, state.a, found.knots, *forces)]
    return found.events, found.end, found.cut, numbers


@pytest.mark.parametrize("recipe", RECIPES)
def test_a_continued_motion_is_a_new_one(recipe: str) -> None:
    for index in range(4):
        scene = sample(recipe, "hard", seed=3, index=index)
        mechanism = replace(scene.mechanism)
        asked = [(share * scene.horizon, error) for share in SHARES for error in (1e-11, 1e-7)]
        continued = [told(motion(mechanism, *each)) for each in asked]
        assert continued == [told(motion(replace(mechanism), *each)) for each in asked]


def sliding() -> Mechanism:
    builder = Builder()
    builder.room().body("cart", 1.0).slide(X, 1.0)
    return builder.finish()


def test_a_motion_that_is_asked_for_again_is_not_simulated_again() -> None:
    mechanism = sliding()
    first = motion(mechanism, 1.0)
    assert motion(mechanism, 1.0) is first
    assert motion(mechanism, 2.0) is not first
    assert first.end == 1.0
    assert motion(replace(mechanism), 1.0) is not first


def test_only_the_latest_mechanism_is_kept() -> None:
    one, other = sliding(), sliding()
    first = motion(one, 1.0)
    motion(other, 1.0)
    assert motion(one, 1.0) is not first
