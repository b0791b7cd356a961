"""What strategies say of mechanisms, against what the exact engine does with them."""

import pytest

from sim2reason.datasets.random_scenes import sample
from sim2reason.recipes import RECIPES
from sim2reason.simulation.engines.exact.engine import motion
from sim2reason.solutions.strategies import accelerates

SHARE = 0.01  # of the horizon


@pytest.mark.parametrize("recipe", list(RECIPES))
def test_accelerations_change_where_the_engine_integrates(recipe: str) -> None:
    """It follows a motion by steps of an integrator just where accelerations change as it moves."""
    scene = sample(recipe, "medium", seed=3)
    segments = motion(scene.mechanism, SHARE * scene.horizon).segments
    assert bool(accelerates(scene.mechanism)) == any(segment.flow is not None for segment in segments)
