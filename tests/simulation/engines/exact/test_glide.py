"""Tests of the times of events in motions whose lengths are quadratic in time."""

from math import inf, sqrt

import pytest

from sim2reason.simulation.engines.exact.glide import CONTACT_DISTANCE, Approach, crossing

SIZES = [1e-6, 1e-3, 1.0, 1e3]
"""Units of time, in s: what happens does not depend on the unit, however short."""


def curved(aside: float, unit: float) -> Approach:
    """Return two balls 1 m apart that near each other by 1 m per unit of time and, slowly, move aside."""
    return Approach((1.0, aside, 0.0), (-1.0 / unit, 0.0, 0.0), (0.0, 0.0, 0.01 / unit**2), 0.1)


@pytest.mark.parametrize("unit", SIZES)
def test_balls_on_a_curved_path_hit_or_pass(unit: float) -> None:
    """The separation is ((1 − τ), 0.08, 0.005 τ²) m; at τ = t it is 0.1 m."""
    time = curved(0.08, unit).hit() / unit
    assert sqrt((1.0 - time) ** 2 + 0.08**2 + (0.005 * time**2) ** 2) == pytest.approx(0.1, rel=1e-12)
    assert 0.9 < time < 1.0
    assert curved(0.11, unit).hit() == inf


@pytest.mark.parametrize("unit", SIZES)
def test_a_ball_thrown_up_at_another_hits_it_going_up(unit: float) -> None:
    """The gap is 1 − 3τ + τ² m on a line and, with a part of the speed across, opens or never closes."""
    straight = Approach((0.0, 0.0, 1.1), (0.0, 0.0, -3.0 / unit), (0.0, 0.0, 2.0 / unit**2), 0.1)
    assert straight.hit() / unit == pytest.approx((3.0 - sqrt(5.0)) / 2.0, rel=1e-12)
    away = Approach((0.0, 0.0, 1.1), (0.0, 1.0 / unit, 1.0 / unit), (0.0, 0.0, -1.0 / unit**2), 0.1)
    assert away.hit() == inf
    turned = Approach((0.0, 0.0, 1.1), (0.0, 0.0, 1.0 / unit), (0.0, 0.0, -1.0 / unit**2), 0.1)
    assert turned.hit() / unit == pytest.approx(1.0 + sqrt(3.0), rel=1e-12)


@pytest.mark.parametrize(
    ("gap", "speed", "acceleration", "time"),
    [
        (2.0, -1.0, 0.0, 2.0),
        (2.0, 0.0, -4.0, 1.0),
        (2.0, 1.0, -2.0, 2.0),
        (3.0, -4.0, 2.0, 1.0),
        (2.0, -2.0, 1.0, 2.0),  # it touches as it turns
        (2.0, -2.0, 1.01, inf),
        (2.0, 0.0, 0.0, inf),
        (2.0, 0.0, 1.0, inf),
        (2.0, 1.0, 0.0, inf),
        (0.0, 1.0, -2.0, 1.0),  # it is thrown up from contact and falls back
        (0.0, 1.0, 0.0, inf),
        (0.0, 0.0, 1.0, inf),
        (0.0, 0.0, -1.0, 0.0),
        (0.0, -1.0, 5.0, 0.0),
        (0.0, 0.0, 0.0, inf),
        (CONTACT_DISTANCE, -1.0, 0.0, 0.0),
        (-1.0, -1.0, 0.0, 0.0),
        (-1.0, 0.0, -1.0, 0.0),
    ],
)
def test_a_gap_that_is_quadratic_in_time_closes(gap: float, speed: float, acceleration: float, time: float) -> None:
    assert crossing(gap, speed, acceleration) == pytest.approx(time, rel=1e-12)


def test_a_distant_gap_closes_as_exactly_as_a_near_one() -> None:
    """A fall of 1 mm at 1 km/s takes 1 µs, but for g t/2v of it."""
    assert crossing(1e-3, -1e3, -9.8) == pytest.approx(1e-6 * (1.0 - 4.9e-9), rel=1e-13)
