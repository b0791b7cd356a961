"""Tests of bobs whose string goes slack against energy, free flight and a jerk computed here."""

from dataclasses import dataclass
from math import acos, atan2, cos, hypot, radians, sin, sqrt

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from sim2reason.questions import Query, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.strings import WentTaut
from sim2reason.questions.moments.times import AtTime
from sim2reason.questions.moments.turning_points import HighestPoint, Stopped
from sim2reason.scenes.bodies.oscillators import Ball, Cord, LightRod
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum
from sim2reason.solutions import STRATEGIES, solve_with
from worked import answer, asked

G, LENGTH, MASS = 9.8, 0.8, 0.5
BOB, HANGER = "pendulum.bob", "pendulum.hanger"


def scene(angle: float, speed: float | None, *, rod: bool = False) -> Pendulum:
    hanger = LightRod(length=LENGTH) if rod else Cord(length=LENGTH)
    return Pendulum(bob=Ball(mass=MASS), hanger=hanger, angle=angle, speed=speed)


def speed_to(angle: float, share: float) -> float:
    """Return a launch speed with which the string goes slack on the upper half of the circle (0: level, 1: top)."""
    return round(sqrt(G * LENGTH * (2.0 * cos(radians(angle)) + 3.0 * share)), 2)


@dataclass(frozen=True)
class Flight:
    """Free flight between slack and taut; x points to the side of the start, y up from the fixed point."""

    angle: float
    speed: float

    @property
    def slack(self) -> tuple[float, float, float, float]:
        """Position and velocity when the string goes slack: cos φ = (2 cos θ − v²/gℓ)/3 and v² = −g ℓ cos φ."""
        phi = acos((2.0 * cos(radians(self.angle)) - self.speed**2 / (G * LENGTH)) / 3.0)
        v = sqrt(-G * LENGTH * cos(phi))
        return LENGTH * sin(phi), -LENGTH * cos(phi), v * cos(phi), v * sin(phi)

    @property
    def top(self) -> float:
        """Greatest height of the flight above the starting point."""
        _, y, _, vy = self.slack
        return y + vy**2 / (2.0 * G) + LENGTH * cos(radians(self.angle))

    @property
    def taut(self) -> tuple[float, float, float, float]:
        """Position and velocity when the path meets the circle again, by bisection."""
        x, y, vx, vy = self.slack

        def apart(t: float) -> float:
            return hypot(x + vx * t, y + vy * t - 0.5 * G * t * t) - LENGTH

        low, high = vy / G, 8.0 * vy / G
        for _ in range(200):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if apart(middle) < 0.0 else (low, middle)
        return x + vx * low, y + vy * low - 0.5 * G * low**2, vx, vy - G * low


CASES = [(0.0, 0.6), (25.0, 0.3), (70.0, 0.8)]


@pytest.mark.parametrize(("angle", "share"), CASES)
def test_how_high_the_projectile_comes(angle: float, share: float) -> None:
    speed = speed_to(angle, share)
    query = Query("event", Target("potential energy", BOB), HighestPoint(BOB))
    expected = MASS * G * Flight(angle, speed).top
    assert answer("pendulum", scene(angle, speed), query) == pytest.approx(expected, rel=1e-8)


@pytest.mark.parametrize(("angle", "share"), CASES)
def test_what_a_jerk_takes_is_the_energy_of_the_motion_along_the_string(angle: float, share: float) -> None:
    speed = speed_to(angle, share)
    x, y, vx, vy = Flight(angle, speed).taut
    lost = 0.5 * MASS * ((x * vx + y * vy) / LENGTH) ** 2
    query = StretchQuery("sum", None, WentTaut(HANGER), "energy lost in a jerk", HANGER)
    assert answer("pendulum", scene(angle, speed), query) == pytest.approx(lost, rel=1e-8)


def test_why_it_is_fastest_at_the_lowest_point() -> None:
    """During the flight the bob is above the lowest point, and the jerk reduces its energy."""
    place = Scene(entities=(Named(name="pendulum", entity=scene(20.0, speed_to(20.0, 0.4))),))
    query = StretchQuery("extremum", None, WentTaut(HANGER), "greatest speed", BOB)
    text = solve_with(STRATEGIES["circle and projectile"], asked(place, query)).text
    assert "By conservation of energy, the speed is greatest at the lowest point." in text
    assert "is above this point and so slower" in text


@settings(max_examples=12, deadline=None)
@given(st.integers(0, 80), st.floats(0.1, 0.9))
def test_before_and_after_a_jerk(angle: int, share: float) -> None:
    """Just after the jerk only the velocity component perpendicular to the string is left."""
    speed = speed_to(float(angle), share)
    x, y, vx, vy = Flight(float(angle), speed).taut
    kept = abs(x * vy - y * vx) / LENGTH
    assume(kept > 0.1 * hypot(vx, vy))  # else five digits of what cancels are not enough
    for after, expected in ((False, hypot(vx, vy)), (True, kept)):
        query = Query("event", Target("velocity", BOB), WentTaut(HANGER, after=after))
        assert answer("pendulum", scene(angle, speed), query) == pytest.approx(expected, rel=1e-7)


def test_after_the_jerk_it_swings_to_where_its_energy_ends() -> None:
    """The speed is zero at the height u²/2g above the point where the string became taut."""
    speed = speed_to(0.0, 0.45)
    x, y, vx, vy = Flight(0.0, speed).taut
    kept = (x * vy - y * vx) / LENGTH
    expected = MASS * G * (y + kept**2 / (2.0 * G) + LENGTH)
    query = Query("event", Target("potential energy", BOB), Stopped(BOB))
    setting = asked(Scene(entities=(Named(name="pendulum", entity=scene(0.0, speed)),)), query)
    found = solve_with(STRATEGIES["circle and projectile"], setting)
    assert found.answer == pytest.approx(abs(expected), rel=1e-7), found.reason
    assert [phase.begins for phase in found.phases] == [
        "the start of the motion",
        "the string becomes slack",
        "the string becomes taut",
    ]
    assert {step.phase for step in found.steps if step.relations} == {0, 1, 2}


@pytest.mark.parametrize("time", [0.75, 1.5])
def test_in_flight_and_on_the_circle_again_at_a_time(time: float) -> None:
    """After the jerk the energy on the circle is constant."""
    angle, speed = 20.0, speed_to(20.0, 0.5)
    flight, pendulum = Flight(angle, speed), scene(20.0, speed)
    found = answer("pendulum", pendulum, Query("state", Target("velocity", BOB), AtTime(time)))
    high = answer("pendulum", pendulum, Query("state", Target("potential energy", BOB), AtTime(time))) / (MASS * G)
    if time < 1.0:
        _, y, vx, vy = flight.slack
        level = 0.5 * (vx**2 + vy**2) + G * y
    else:
        x, y, vx, vy = flight.taut
        level = 0.5 * ((x * vy - y * vx) / LENGTH) ** 2 + G * y
    signs = (high, -high)  # of a height only the size is told
    energies = [0.5 * found**2 + G * (size - LENGTH * cos(radians(angle))) for size in signs]
    assert any(energy == pytest.approx(level, rel=1e-7) for energy in energies)


def test_a_bob_let_go_above_its_fixed_point_falls_until_the_string_is_taut() -> None:
    """The bob falls by 2 ℓ cos 60° and then moves along the circle with v sin 60°."""
    fall = sqrt(2.0 * G * 2.0 * LENGTH * 0.5)
    found = answer("pendulum", scene(120.0, None), Query("event", Target("velocity", BOB), WentTaut(HANGER)))
    assert found == pytest.approx(fall * sin(radians(60.0)), rel=1e-8)
    time = answer("pendulum", scene(120.0, None), Query("time_to_event", None, WentTaut(HANGER)))
    assert time == pytest.approx(fall / G, rel=1e-8)


def test_the_time_at_which_a_string_is_taut_again() -> None:
    """The flight takes 4 v_y/g; the time on the arc before is integrated numerically here."""
    speed = speed_to(0.0, 0.5)
    x, y, _, vy = Flight(0.0, speed).slack
    end, count = atan2(x, -y), 20000
    rates = [sqrt(speed**2 - 2.0 * G * LENGTH * (1.0 - cos(end * (n + 0.5) / count))) / LENGTH for n in range(count)]
    arc = sum(end / count / rate for rate in rates)
    found = answer("pendulum", scene(0.0, speed), Query("time_to_event", None, WentTaut(HANGER)))
    assert found == pytest.approx(arc + 4.0 * vy / G, rel=1e-7)


def test_a_rod_never_goes_slack() -> None:
    setting = asked(
        Scene(entities=(Named(name="pendulum", entity=scene(0.0, speed_to(0.0, 0.5), rod=True)),)),
        Query("event", Target("potential energy", BOB), HighestPoint(BOB)),
    )
    found = solve_with(STRATEGIES["circle and projectile"], setting)
    assert found.reason == "no small body swings on a string"
