"""Tests of motions solved phase by phase against closed forms, with answers recomputed from the solutions."""

from dataclasses import replace
from math import asin, cos, degrees, pi, radians, sin, sqrt

import numpy as np
import pytest

from sim2reason.questions import Query, StatedResult, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.angles import Deflected
from sim2reason.questions.moments.strings import WentTaut
from sim2reason.questions.moments.times import AtTime, WholeMotion
from sim2reason.questions.moments.turning_points import HighestPoint, LowestPoint
from sim2reason.scenes.bodies.oscillators import Ball, Cord, LightRod
from sim2reason.scenes.dsl.entity import Entity, Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum
from sim2reason.solutions import STRATEGIES, ProblemContext, Solution, solve_with
from sim2reason.solutions.checking import recompute
from sim2reason.solutions.data import as_data
from sim2reason.solutions.solution import Step
from sim2reason.testing.solution_text import read
from worked import asked

G = 9.8
BOB = "swing.bob"


def integrated(entity: Entity, query: Query, **changes: object) -> Solution:
    """Return the solution by integration after checking that its data and its text lead to its answer."""
    setting: ProblemContext = asked(scene(entity), query)
    setting = replace(setting, **changes)  # type: ignore[arg-type]
    found = solve_with(STRATEGIES["integration"], setting)
    assert found.answer is not None, found.reason
    again = recompute(as_data(found))
    assert not again.faults, again.faults
    assert again.answer == pytest.approx(found.answer, rel=1e-8)
    reading = read(found.text)
    assert not reading.unread
    assert not reading.broken, reading.broken
    return found


def on_rod(angle: float, length: float = 1.5, speed: float | None = None) -> Pendulum:
    return Pendulum(bob=Ball(mass=1.3), hanger=LightRod(length=length), angle=angle, speed=speed)


def scene(entity: Entity) -> Scene:
    return Scene(entities=(Named(name="swing", entity=entity),))


def on_string(speed: float, length: float = 1.8) -> Pendulum:
    return Pendulum(bob=Ball(mass=1.8), hanger=Cord(length=length), angle=0.0, speed=speed)


STRING = scene(on_string(7.5)).mechanism.strings[0].name


def quarter(angle: float, length: float) -> float:
    """Return a quarter of the period of a pendulum, from the elliptic integral K by the midpoint rule."""
    modulus = sin(radians(angle) / 2.0)
    points = (np.arange(200) + 0.5) * pi / 400.0
    return sqrt(length / G) * pi / 2.0 * float(np.mean(1.0 / np.sqrt(1.0 - (modulus * np.sin(points)) ** 2)))


def test_a_rod_reaches_its_lowest_point_after_a_quarter_of_a_swing() -> None:
    found = integrated(on_rod(67), Query("time_to_event", None, LowestPoint(BOB)))
    assert found.answer == pytest.approx(quarter(67, 1.5), rel=1e-8)
    assert r"\varphi = \theta" in found.text  # an angle from the vertical, not a displacement


def test_the_speed_at_an_angle_is_that_of_energy() -> None:
    line = next(iter(asked_lines(on_rod(67))))
    found = integrated(on_rod(67), Query("event", Target("velocity", BOB), Deflected(line, 30.0)))
    assert found.answer == pytest.approx(sqrt(2.0 * G * 1.5 * (cos(radians(30)) - cos(radians(67)))), rel=1e-8)


def asked_lines(entity: Entity) -> list[str]:
    """Return the names of the swinging bodies whose angle may be asked for."""
    setting = asked(scene(entity), Query("time_to_event", None, LowestPoint(BOB)))
    return list(Deflected.candidates(setting.words))


def test_the_greatest_speed_is_that_at_the_lowest_point() -> None:
    found = integrated(on_rod(50), StretchQuery("extremum", None, WholeMotion(), "greatest speed", BOB))
    assert found.answer == pytest.approx(sqrt(2.0 * G * 1.5 * (1.0 - cos(radians(50)))), rel=1e-8)


def test_an_angle_that_is_asked_for_is_found_by_trial() -> None:
    time = quarter(40, 1.1)
    speed = sqrt(2.0 * G * 1.1 * (1.0 - cos(radians(40))))
    query = Query("state", Target("velocity", BOB), AtTime(time))
    found = integrated(on_rod(40, 1.1), query, unknown="swing.angle", stated=StatedResult(repr(speed), "m/s"))
    assert found.answer == pytest.approx(40.0)
    assert "varied until" in found.text


def slack(speed: float, length: float) -> tuple[float, float]:
    """Return the angle from the upward vertical at which a string goes slack, and the speed: v² = gℓ cos β."""
    cosine = (speed**2 / (G * length) - 2.0) / 3.0
    return asin(sqrt(1.0 - cosine**2)), sqrt(G * length * cosine)


def test_a_string_that_goes_slack_lets_the_bob_fly_as_a_projectile() -> None:
    beta, v = slack(7.5, 1.8)
    found = integrated(on_string(7.5), Query("event", Target("velocity", BOB), HighestPoint(BOB)))
    assert found.answer == pytest.approx(v * cos(beta), rel=1e-8)
    assert found.phases[0].ends.endswith("goes slack")
    assert "constant" in found.text  # the flight is in closed form


def test_the_string_becomes_taut_again_as_known_for_launches_from_rest_below() -> None:
    """The parabola that begins at the angle β above the horizontal meets the circle again after 4 (v/g) sin β."""
    beta, v = slack(7.5, 1.8)
    fly = 4.0 * v / G * sin(beta)
    found = integrated(on_string(7.5), Query("time_to_event", None, WentTaut(STRING)))
    first = found.values["t_1"]
    assert found.answer is not None
    assert found.answer - first == pytest.approx(fly, rel=1e-7)
    assert degrees(beta) < 90.0


def test_a_jerk_takes_the_velocity_along_the_string() -> None:
    """After the free flight of 4 (v/g) sin β, the velocity component along the string is lost."""
    beta, v = slack(7.5, 1.8)
    fly = 4.0 * v / G * sin(beta)
    x, z = -1.8 * sin(beta), 1.8 * cos(beta)
    vx, vz = v * cos(beta), v * sin(beta)
    place = np.array([x + vx * fly, z + vz * fly - G * fly**2 / 2.0]) / 1.8
    before = np.array([vx, vz - G * fly])
    after = before - (before @ place) * place
    found = integrated(on_string(7.5), Query("event", Target("velocity", BOB), WentTaut(STRING, after=True)))
    assert found.answer == pytest.approx(float(np.linalg.norm(after)), rel=1e-7)


def without(found: Solution, drop: type[object] | str) -> Solution:
    """Return a copy of a solution without its steps of a given kind."""
    steps: tuple[Step, ...] = tuple(step for step in found.steps if step.kind != drop)
    return replace(found, steps=steps)


@pytest.mark.parametrize("kind", ["event", "duration", "integration"])
def test_a_solution_without_one_of_its_parts_leads_to_nothing(kind: str) -> None:
    found = integrated(on_string(7.5), Query("event", Target("velocity", BOB), WentTaut(STRING, after=True)))
    assert recompute(as_data(without(found, kind))).faults
