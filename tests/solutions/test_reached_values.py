"""Tests of quantities at the moment when another quantity reaches a given value."""

from math import acos, cos, degrees, radians, sin, sqrt

import pytest

import sim2reason
from own_questions import DATA, G, solved
from sim2reason.solutions import STRATEGIES, Solution

RAMP = G * (0.5 - 0.2 * cos(radians(30.0)))  # the acceleration of the block, m/s²
RISE = 8.6 * sin(radians(59.0))  # the initial vertical velocity of the hopping ball, m/s


@pytest.mark.parametrize(
    ("name", "find", "when", "of", "expected"),
    [
        ("ramp", "displacement", "speed = 2.5 m/s", "", 2.5**2 / (2.0 * RAMP)),
        ("ramp", "displacement", "speed = 2 m/s", "", 2.0**2 / (2.0 * RAMP)),
        ("ramp", "speed", "displacement = 1.2 m", "", sqrt(2.0 * RAMP * 1.2)),
        ("ramp", "kinetic energy", "speed = 2.5 m/s", "", 2.5**2),
        ("ramp", "speed", "kinetic energy = 10 J", "", sqrt(10.0)),
        ("rough_slope", "displacement", "speed of block B = 1 m/s", "block A", None),
        ("cliff", "height above the ground", "speed = 50 m/s", "", 180.0 - (50.0**2 - 25.0**2) / (2.0 * G)),
        ("cliff", "height above the start", "speed = 23 m/s", "", (25.0**2 - 23.0**2) / (2.0 * G)),
        ("cliff", "speed", "height above the ground = 100 m", "", sqrt(25.0**2 + 2.0 * G * 80.0)),
        ("cliff", "time", "height above the ground = 100 m", "", (12.5 + sqrt(12.5**2 + 160.0 * G)) / G),
        ("hopper", "height above the ground", "speed = 7 m/s", "", 4.2 + (8.6**2 - 7.0**2) / (2.0 * G)),
        ("pendulum", "speed", "deflection = 20 deg", "", None),
        ("pendulum", "tension", "speed = 1 m/s", "", 0.4 * (G * (1.0 / (3.0 * G) + cos(radians(35.0))) + 1.0 / 1.5)),
        ("pendulum", "deflection", "speed = 1 m/s", "", degrees(acos(1.0 / (3.0 * G) + cos(radians(35.0))))),
        ("pendulum", "speed", "height above the start = 0.1 m", "", sqrt(0.2 * G)),
        ("rod", "angle turned", "angular velocity = 2 rad/s", "the rod", None),
        ("oscillator", "extension", "speed = 0.5 m/s", "", sqrt(0.01 - 0.5 * 0.25 / 50.0)),
        ("oscillator", "speed", "extension = 0.05 m", "", sqrt(100.0 * (0.01 - 0.0025))),
        ("skid", "displacement", "speed = 2 m/s", "", (36.0 - 4.0) / (2.0 * 0.25 * G)),
        ("rocket", "displacement", "speed = 1640 m/s", "", None),
        ("rocket", "kinetic energy", "speed = 1640 m/s", "", None),
        ("rough_pair", "acceleration", "speed = 0.294 m/s", "block B", None),
        ("rolling_ball", "angular velocity", "speed = 3 m/s", "", 3.0 / 0.058),
    ],
)
def test_it_leads_to_the_answer(name: str, find: str, when: str, of: str, expected: float | None) -> None:
    found = solved(name, find, when, of)
    assert expected is None or found.answer == pytest.approx(expected, rel=1e-6)
    assert found.solution.derived


def test_where_energy_gives_the_place_no_time_is_found() -> None:
    for name, find, when in (("ramp", "displacement", "speed = 2.5 m/s"), ("pendulum", "tension", "speed = 1 m/s")):
        assert "$t$" not in solved(name, find, when).solution.text


@pytest.mark.parametrize(
    ("when", "time", "reason"),
    [
        ("height above the ground = 5 m", (RISE - sqrt(RISE**2 - 1.6 * G)) / G, "is later: $t$ is the first time"),
        ("second height above the ground = 5 m", (RISE + sqrt(RISE**2 - 1.6 * G)) / G, "is earlier: $t$ is the second"),
    ],
)
def test_of_two_times_the_text_says_which_one_is_asked_for(when: str, time: float, reason: str) -> None:
    found = solved("hopper", "displacement", when)
    assert found.answer == pytest.approx(sqrt((8.6 * cos(radians(59.0)) * time) ** 2 + 0.8**2), rel=1e-6)
    assert reason in found.solution.text


def test_a_root_that_would_be_earlier_than_the_start_is_excluded() -> None:
    found = solved("cliff", "height above the ground", "speed = 50 m/s")
    assert "would take a negative $t$" in found.solution.text


def test_a_value_that_follows_from_the_stated_one_needs_no_moment() -> None:
    found = solved("ramp", "kinetic energy", "speed = 2.5 m/s").solution
    assert [step.kind for step in found.steps] == ["givens", "answer"]


@pytest.mark.parametrize("only", ["phase by phase", "integration"])
def test_a_motion_is_also_followed_to_that_moment(only: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """Without a law for the moment, the value is the condition that ends the last phase."""
    for name, strategy in STRATEGIES.items():
        if name != only:
            monkeypatch.setattr(strategy, "kinds", frozenset[str](), raising=False)
    name = "ramp" if only == "phase by phase" else "oscillator"
    assert solved(name, "displacement", "speed = 0.5 m/s").solution.strategy == only


def test_the_stated_value_itself_is_not_derived() -> None:
    scene = next(DATA.glob("*_scenes/cliff.yaml"))
    found: Solution = sim2reason.solve(scene, find="speed", when="speed = 50 m/s").solution
    assert found.answer is None
