"""Tests of mechanisms restarted at another position and velocity."""

import numpy as np
import pytest

from sim2reason.errors import SceneError, UnsupportedError
from sim2reason.generation.item_search import generator
from sim2reason.generation.recipes import RECIPES
from sim2reason.questions.difficulty import DIFFICULTIES
from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.frames import initial_frames
from sim2reason.scenes.dsl.mechanism import X, Y, Z
from sim2reason.scenes.dsl.state import displace
from sim2reason.simulation.engines.exact import simulate
from sim2reason.simulation.equilibrium import steady

SEEDS = range(2)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("difficulty", DIFFICULTIES)
@pytest.mark.parametrize("recipe", sorted(RECIPES))
def test_a_motion_goes_on_as_it_was(recipe: str, difficulty: str, seed: int) -> None:
    """A motion restarted at 0.4 of the time to the first event agrees at 0.9 of it with the original one."""
    rng = generator(recipe, difficulty, "numeric", seed, 0, 0)
    try:
        scene = RECIPES[recipe](difficulty, rng)
    except SceneError:
        return
    mechanism = scene.mechanism
    trace = simulate(mechanism, np.linspace(0.0, scene.horizon, 11))
    changes = [event.time for event in trace.events if event.changes_motion]
    end = min([trace.stable_until, *changes])
    if end < 1e-3 * scene.horizon or not steady(mechanism):
        return
    there = trace.sample(np.array([0.4 * end, 0.9 * end]))
    again = displace(mechanism, there.q[0].tolist(), there.v[0].tolist())
    state = simulate(again, np.array([0.0, 0.5 * end])).state
    size = max(1.0, float(np.abs(there.q).max()))
    assert np.allclose(state.q[1], there.q[1] - there.q[0], rtol=0.0, atol=1e-8 * size)
    assert np.allclose(state.v[1], there.v[1], rtol=1e-7, atol=1e-7)
    for name, tension in there.tension.items():
        assert np.allclose(state.tension[name][1], tension[1], rtol=1e-6, atol=1e-6, equal_nan=True)


def test_slack_and_wound_strings_keep_their_length() -> None:
    """A string with 0.3 m of slack has 0.5 m after its end has risen by 0.2 m."""
    builder = Builder()
    room = builder.room().site("nail")
    room.body("load", 1.0, at=(0.0, 0.0, -1.0)).slide(Z, limits=(-0.3, 0.9)).site("hook")
    room.string("string", "nail", "hook", slack=0.3)
    mechanism = displace(builder.finish(), [0.2], [0.0])
    assert mechanism.line["string"].law.slack == pytest.approx(0.5)
    assert initial_frames(mechanism).length(mechanism.line["string"]) == pytest.approx(0.8)
    (coordinate,) = mechanism.coordinates
    assert (coordinate.lower, coordinate.upper) == pytest.approx((-0.5, 0.7))


def test_a_body_that_has_left_its_own_hinge_can_not_begin_there() -> None:
    """A bead that slides along a rotating rod, both in one body, is not supported."""
    builder = Builder()
    builder.room().body("bead", 1.0).hinge(Y).slide(X)
    with pytest.raises(UnsupportedError, match="hinge"):
        displace(builder.finish(), [0.1, 0.5], [0.0, 0.0])
