"""Tests of the precision of small nonlinear motions relative to their own size."""

from math import cos, radians, sqrt

import numpy as np
import pytest

from motions import light_rod
from plain_scenes import G
from sim2reason.simulation.engines.exact import simulate

LENGTH = 0.8  # m


def test_a_tiny_pendulum_keeps_time() -> None:
    """The motion is θ = θ₀ cos ωt with ω = √(g/ℓ) (1 − θ₀²/16), up to a relative error of order θ₀², here 3e-10."""
    angle, first, time = 1e-3, radians(1e-3), 20.0
    turned = abs(simulate(light_rod(angle).mechanism, np.array([0.0, time])).sample(np.array([time])).q[0, 0])
    rate = sqrt(G / LENGTH) * (1.0 - first**2 / 16.0)
    assert turned == pytest.approx(first * (1.0 - cos(rate * time)), abs=1e-9 * first)
