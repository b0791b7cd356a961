"""Tests of the values at which formulas are compared."""

from math import pi

import pytest

from sim2reason.grading import arithmetic

THETA, LENGTH = arithmetic.symbol("theta"), arithmetic.symbol("h")


def drawn(name: str, given: float) -> list[float]:
    node = arithmetic.symbol(name)
    return [point[name] for point in arithmetic.draw_points(node, [name], [{name: given}], {}, "seed")]


@pytest.mark.parametrize(
    ("angle", "low", "high"),
    [(0.5, 0.5 / 3.0, 0.5 * pi), (1.2, 0.4, 0.5 * pi), (2.0, 0.5 * pi, pi), (3.0, 0.5 * pi, pi)],
)
def test_an_angle_stays_in_its_quadrant_and_is_drawn_from_most_of_it(angle: float, low: float, high: float) -> None:
    """So that sines and cosines keep their signs; no angle is less than a third of the stated one."""
    values = drawn("theta", angle)
    assert len(values) == arithmetic.TEST_POINTS
    assert low < min(values) < low + 0.25 * (high - low)
    assert high - 0.25 * (high - low) < max(values) < high


@pytest.mark.parametrize("stated", [0.02, 4.0, -3.0])
def test_other_values_are_drawn_up_to_a_factor_of_three_away(stated: float) -> None:
    ratios = [value / stated for value in drawn("h", stated)]
    assert 1.0 / 3.0 <= min(ratios) < 0.6
    assert 1.6 < max(ratios) <= 3.0


@pytest.mark.parametrize("name", ["theta", "h"])
def test_without_stated_values_they_are_usual_ones(name: str) -> None:
    node = arithmetic.symbol(name)
    values = [point[name] for point in arithmetic.draw_points(node, [name], [], {}, "seed")]
    usual, wide = values[: arithmetic.TEST_POINTS], values[arithmetic.TEST_POINTS :]
    assert all(0.2 <= value <= 1.5 for value in usual)
    assert min(wide) < 0.02
    assert 0.5 < max(wide) <= (1.5 if name == "theta" else 5.0)


def test_within_a_given_range_all_is_drawn() -> None:
    values = [p["h"] for p in arithmetic.draw_points(LENGTH, ["h"], [], {"h": (10.0, 20.0)}, "seed")]
    assert 10.0 <= min(values) < 12.0
    assert 18.0 < max(values) <= 20.0


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_a_difference_changes_its_sign_somewhere(sign: float) -> None:
    """The larger of two given values becomes the smaller one, so that a lost sign shows."""
    node = arithmetic.total([(THETA, False), (LENGTH, True)])
    given = {"theta": 1.0 + 0.2 * sign, "h": 1.0 - 0.2 * sign}
    points = arithmetic.opposite_sign_points(node, ["theta", "h"], [given], sign, "seed")
    assert len(points) == 2
    assert all((point["theta"] - point["h"]) * sign < 0.0 for point in points)


def test_a_point_at_which_digits_cancel_is_left_out() -> None:
    node = arithmetic.total([(THETA, False), (LENGTH, True)])
    near, far = {"theta": 1.0, "h": 1.0 - 1e-6}, {"theta": 1.0, "h": 0.5}
    assert arithmetic.well_conditioned_points(node, [near, far]) == [(far, 0.5)]
    assert not arithmetic.well_conditioned_points(node, [{"theta": 1.0, "h": 1.0}])
