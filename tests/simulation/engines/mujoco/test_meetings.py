"""Tests that the MuJoCo engine ends a motion where two points of a line meet, as the exact engine does."""

from math import acos, hypot, sqrt

import numpy as np
import pytest

from sim2reason.scenes.dsl.builder import Builder
from sim2reason.scenes.dsl.mechanism import Mechanism, X, Y
from sim2reason.simulation.trace import ENGINES


def sprung(x: float, y: float, mass: float, stiffness: float, length: float) -> Mechanism:
    """Build a body at rest that a spring pulls straight to a nail at (x, y)."""
    builder = Builder()
    room = builder.room("it")
    room.body("body", mass).slide(X, name="x").slide(Y, name="y").site("hook")
    room.site("nail", (x, y, 0.0))
    room.spring("spring", room.address("nail"), room.address("hook"), stiffness=stiffness, length=length)
    return builder.finish()


@pytest.mark.parametrize("engine", ["exact", "mujoco"])
@pytest.mark.parametrize(
    ("nail", "spring", "duration"),
    [
        ((-0.64, -0.66), (8.2, 101.0, 0.24), 3.580602440354211),
        ((0.76, 0.57), (2.5, 95.0, 0.25), 2.0385344995171986),
        ((0.2, -0.9), (2.0, 50.0, 0.2), 3.0),
    ],
)
def test_a_body_is_drawn_straight_to_a_nail(
    engine: str, nail: tuple[float, float], spring: tuple[float, float, float], duration: float
) -> None:
    """The distance to the nail is r = ℓ + (d − ℓ) cos ωt with ω² = k/m, until r = 0."""
    mass, stiffness, length = spring
    far, omega = hypot(*nail), sqrt(stiffness / mass)
    meets = acos(-length / (far - length)) / omega
    found = ENGINES[engine](sprung(*nail, *spring), np.linspace(0.0, duration, 101))
    assert (found.cut, found.stable_until) == ("reach", pytest.approx(meets, rel=1e-5))
    assert found.stable_until < meets  # on the hither side
    before = found.state.times < meets
    speed = (far - length) * omega * np.sin(omega * found.state.times[before])
    assert np.hypot(*found.state.v[before].T) == pytest.approx(speed, rel=1e-6, abs=1e-6)
