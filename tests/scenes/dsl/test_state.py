"""Tests of lazy evaluation in states."""

import numpy as np
import pytest

from plain_scenes import G, half_atwood
from sim2reason.simulation.quantities.kinematics import Velocity
from sim2reason.simulation.scenes import simulate


def test_forces_are_worked_out_only_where_they_are_asked_for() -> None:
    """The block's velocity needs no forces; its acceleration, which is constant and less than g, does."""
    state = simulate(half_atwood(), duration=0.5).sample(np.array([0.2, 0.4]))
    speeds = np.linalg.norm(Velocity.evaluate(state, "ramp.blocks.0"), axis=1)
    assert "_dynamics" not in vars(state)
    assert np.abs(state.a[0]).max() == pytest.approx((speeds[1] - speeds[0]) / 0.2)
    assert "_dynamics" in vars(state)
    assert 0.0 < np.abs(state.a[0]).max() < G
