"""Tests of how clearly a string stays taut."""

import numpy as np
import pytest

from plain_scenes import atwood
from sim2reason.questions import SimulatedScene
from sim2reason.questions.regimes.strings import StaysTaut
from sim2reason.scenes.dsl.scene import Scene


def taut(scene: Scene) -> tuple[StaysTaut, SimulatedScene]:
    study = SimulatedScene.of(scene, np.linspace(0.0, 0.4, 5))
    (string,) = study.mechanism.strings
    return StaysTaut(string.name), study


@pytest.mark.parametrize(("left", "right"), [(3.0, 2.0), (2.0, 3.0), (5.0, 0.1), (2.0, 2.0)])
def test_cut_the_loads_of_a_light_pulley_would_part_at_twice_free_fall(left: float, right: float) -> None:
    """The tension T = 2 m1 m2 g/(m1 + m2), on both masses, is 2 g of relative acceleration, whatever the masses are."""
    regime, study = taut(atwood(left, right))
    assert regime.holds(study, 0.3)
    assert regime.margin(study, 0.3) == pytest.approx(2.0, rel=1e-9)
