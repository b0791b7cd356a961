"""Tests of greatest and least values at an end of a time interval: their value and their reason."""

from math import cos, log, radians, sin, sqrt

import pytest

from own_questions import G, solved

ALONG = "has a component along its velocity, so its speed increases"
FALLS = "only gravity does work on the ball"


@pytest.mark.parametrize(
    ("name", "find", "when", "of", "expected", "why"),
    [
        ("cliff", "greatest speed", "landed", "", sqrt(25.0**2 + 2.0 * G * 180.0), FALLS),
        ("cliff", "greatest speed", "", "", sqrt(25.0**2 + 2.0 * G * 180.0), "nowhere lower than where it lands"),
        ("cliff", "greatest kinetic energy", "landed", "", 0.6 * (25.0**2 + 2.0 * G * 180.0), FALLS),
        ("cliff", "greatest speed", "2 s", "", 25.0, "nowhere lower than where it starts"),
        ("ramp", "greatest speed", "moved 2 m", "", sqrt(4.0 * G * (0.5 - 0.2 * cos(radians(30.0)))), "From rest"),
        ("ramp", "greatest speed", "2 s", "", 2.0 * G * (0.5 - 0.2 * cos(radians(30.0))), "From rest its speed"),
        ("atwood", "greatest speed", "moved 1 m", "block B", sqrt(2.0 * G * 2.0 / 8.0), "a constant acceleration"),
        ("rolling_ball", "greatest speed", "moved 1 m", "", sqrt(2.7**2 + 10.0 / 7.0 * G * sin(radians(18.0))), ALONG),
        ("pendulum", "greatest speed", "deflected 20 deg", "", None, ALONG),
        ("oscillator", "greatest speed", "0.1 s", "", sin(1.0), ALONG),
        ("rocket", "greatest speed", "burned out", "", 2500.0 * log(2.5) - G * 60.0, ALONG),
        ("hopper", "greatest speed", "bounced", "", sqrt(8.6**2 + 2.0 * G * 4.2), FALLS),
        ("hard_bounces", "greatest speed", "", "", sqrt(4.4**2 + 2.0 * G * 3.7), "just before the first impact"),
        ("rocket", "greatest speed", "66.6 s", "", 2500.0 * log(2.5) - G * 60.0, "is that at burn-out"),
        ("rough_return", "greatest speed", "0.74 s", "", None, "constant in each part of its motion"),
        ("level_throw", "least speed", "0.771 s", "", 8.6, "its least speed is that at the start"),
        ("cliff", "greatest displacement", "landed", "", None, "the ball moves away from its starting point"),
        ("ramp", "greatest displacement", "2 s", "", 2.0 * G * (0.5 - 0.2 * cos(radians(30.0))), "moves away from"),
        ("glide_up", "greatest speed", "2 s", "", 2.0 * G * sin(radians(25.0)) - 3.3, "opens upward"),
    ],
)
def test_it_is_the_value_at_the_end_and_the_text_says_why(
    name: str, find: str, when: str, of: str, expected: float | None, why: str
) -> None:
    found = solved(name, find, when, of)
    assert expected is None or found.answer == pytest.approx(expected, rel=1e-6)
    assert why in found.solution.text


def test_at_the_start_nothing_but_the_reason_is_written() -> None:
    """A block slowed down by friction and gravity is fastest at the start, with the given speed."""
    found = solved("martian_ramp", "greatest speed", "stopped")
    assert found.solution.text.startswith(r"Given: $v = 6.0\ \text{m/s}$.")
    assert "opposite to its velocity, so its speed decreases" in found.solution.text
    assert found.solution.text.endswith(r"Answer: $v \approx \boxed{6.00}\ \text{m/s}$.")


def test_the_speed_of_a_charge_on_a_circle_is_constant() -> None:
    """The solution says that the magnetic force does no work, without a drift velocity."""
    assert "does no work, so the speed is always" in solved("cyclotron", "greatest speed").solution.text


def test_a_smooth_extreme_within_the_stretch_is_none_at_its_end() -> None:
    """A pendulum is fastest at the lowest point, which is within the time interval."""
    text = solved("pendulum", "greatest speed").solution.text
    assert "at the end" not in text
    assert "at the lowest point" in text
