"""Tests of statements about rolling bodies: the acceleration of the rim, and the direction of friction."""

from dataclasses import replace
from math import cos, radians, sin

import pytest

from plain_scenes import drawn_shell
from sim2reason.questions import Query, StatedResult, Target
from sim2reason.questions.moments.times import AtStart, AtTime
from sim2reason.scenes.bodies.round_bodies import Pipe
from sim2reason.scenes.bodies.simple_machines import Incline
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.rolling import Rolling, RollingEntity, Rough, Spinning, Start
from sim2reason.solutions import STRATEGIES, Solution, solve, solve_with
from sim2reason.solutions.solve import solve_prompt
from sim2reason.testing.solution_verification import faults
from worked import asked, derived, solution_text

G, MASS, RADIUS = 9.8, 2.0, 0.1


def pipe(angle: float, friction: float, start: Start | None = None) -> Scene:
    held = RollingEntity(
        body=Pipe(mass=MASS, radius=RADIUS), plane=Incline(angle=angle), grip=Rough(friction=friction), start=start
    )
    return Scene(entities=(Named(name="lane", entity=held),))


def body(scene: Scene) -> str:
    return next(held.name for held in scene.mechanism.bodies if held.mass)


def turned(scene: Scene, quantity: str, time: float) -> Solution:
    return derived(scene, Query("state", Target(quantity, body(scene)), AtTime(time)))


def test_a_rolling_body_turns_with_the_acceleration_of_its_centre() -> None:
    scene = drawn_shell()
    shell = next(held.name for held in scene.mechanism.bodies if any(held.inertia))
    found = derived(scene, Query("start", Target("acceleration", shell), AtStart()))
    assert "of the rim" not in found.text
    assert "rolls without slipping, so its radius times its angular acceleration is $a$, too." in found.text
    assert "Static friction $f" in found.text
    assert r"whose moment of inertia is $\tfrac{2}{3} m_A R_A^{2}$, divided by its radius $R_A$:" in found.text


def test_what_hangs_on_an_unknown_coefficient_is_verified_in_the_end() -> None:
    """A pipe spinning up a slope begins to roll before the given time; the limit of friction is compared last."""
    scene = pipe(12.0, 0.21, Spinning(spin=16.0, way="up the slope"))
    setting = asked(scene, Query("state", Target("displacement", body(scene)), AtTime(1.8)))
    assert setting.answer is not None
    stated = StatedResult(repr(setting.answer), "m")
    found = solve(replace(setting, unknown="lane.grip.friction", stated=stated))
    assert found.answer is not None, found.reason
    assert not faults(found, found.answer), found.text
    order = [
        "so $\\mu = ",
        "is positive, so the earlier motion ends before $t_1$.",
        "is within the limit of static friction",
    ]
    assert [*map(found.text.find, order)] == sorted(map(found.text.find, order))
    assert found.text.find(order[0]) > 0
    assert "to the right" not in found.text  # the displacement is straight down the slope


def test_what_slips_on_a_slope_is_shown_to() -> None:
    """Rolling without slipping needs half of m g sin θ for a thin pipe; the actual torque is µ m g cos θ R."""
    angle, friction, time = 31.0, 0.18, 1.3
    found = turned(pipe(angle, friction), "angular velocity", time)
    slope = radians(angle)
    assert found.answer == pytest.approx(friction * G * cos(slope) * time / RADIUS)
    rolling, needed, most = (held for held in found.relations if held.role == "verified")
    assert rolling.right.value(found.values) == pytest.approx(0.5 * G * sin(slope))
    assert needed.right.value(found.values) == pytest.approx(0.5 * MASS * G * sin(slope))
    assert most.right.value(found.values) == pytest.approx(friction * MASS * G * cos(slope))
    assert "slips down the slope at the point of contact" in found.text
    assert "acts on it up the slope" in found.text
    assert "times its angular velocity" in found.text


def test_the_speed_of_a_rim_at_first_is_told() -> None:
    """On a slope that is too steep for rolling, the point of contact slips down at once."""
    scene = pipe(45.0, 0.1, Rolling(speed=3.0, way="up the slope"))
    found = turned(scene, "angular velocity", 0.2)
    assert found.answer == pytest.approx((3.0 - 0.1 * G * cos(radians(45.0)) * 0.2) / RADIUS)
    assert "times its angular velocity, at first $v$, is" in found.text


def test_slipping_ends_when_the_speed_of_the_centre_is_that_of_the_rim() -> None:
    """Slipping of a thin pipe ends when a t = R ω₀ − µ g t; from then on no friction is needed."""
    spin, friction = 8.0, 0.4
    scene = pipe(0.0, friction, Spinning(spin=spin, way="to the right"))
    found = turned(scene, "displacement", 0.8)
    time = spin * RADIUS / (2.0 * friction * G)
    assert found.answer == pytest.approx(0.5 * friction * G * time**2 + friction * G * time * (0.8 - time))
    assert r"begins to roll without slipping when $a t = " in found.text
    assert "on level ground needs no friction, so the velocity is constant, which gives $" in found.text


def test_instants_have_their_names() -> None:
    """The speed of the rim relative to the centre is R ω₀ − µ g t until it equals the speed of the centre."""
    scene = pipe(0.0, 0.4, Spinning(spin=8.0, way="to the right"))
    found = turned(scene, "angle rolled", 0.8)
    assert "The magnitude of the net angle of rotation of the" in found.text
    assert "At that time" not in found.text
    assert "In the same time" not in found.text


def test_in_a_later_phase_no_pronoun_stands_for_the_accelerations_of_the_one_before() -> None:
    """On level ground the body has no acceleration once it rolls without slipping."""
    scene = pipe(0.0, 0.4, Spinning(spin=8.0, way="to the right"))
    setting = asked(scene, Query("state", Target("angle rolled", body(scene)), AtTime(0.8)))
    found = solve_with(STRATEGIES["phase by phase"], setting)
    assert setting.answer is not None
    assert not faults(found, setting.answer), found.text
    assert "They remain" not in found.text
    assert "now rolls, which on level ground needs no friction" in found.text


def test_senses_of_turning_are_stated_and_what_is_turned_back() -> None:
    """A roller set spinning up a slope that is too steep to stay on finally turns back, and the text says so."""
    angle, friction, time = 12.0, 0.21, 1.8
    scene = pipe(angle, friction, Spinning(spin=16.0, way="up the slope"))
    found = turned(scene, "angle rolled", time)
    slope = radians(angle)
    a, f = G * sin(slope) - friction * G * cos(slope), friction * G * cos(slope)
    stop = 16.0 * RADIUS / (f - a)
    assert 0.0 < stop < time
    up = 16.0 * RADIUS * stop - 0.5 * f * stop**2
    down = a * stop * (time - stop) + 0.25 * G * sin(slope) * (time - stop) ** 2
    assert found.answer == pytest.approx(abs(up - down) / RADIUS)
    assert "counted as positive in the sense of rolling up the slope" in found.text
    assert "first turns through the arc" in found.text
    assert "in the sense of rolling up the slope, then back through" in found.text
    assert "The magnitude of the net angle of rotation" in found.text
    assert "same time" not in found.text


def test_a_distance_is_reached_only_after_slipping_has_ended() -> None:
    prompt = (
        r"In this problem g = 9.8 m/s². A fixed horizontal plane carries a thin-walled pipe of radius "
        r"0.097 m and mass 5.6 kg, which can roll along it in a straight line. The coefficient "
        r"of friction (static and kinetic) between it and the plane is 0.31. At t = 0 its centre is at "
        r"rest, and it spins at 19 rad/s in the sense in which it would roll to the right. Find the "
        r"angle through which the pipe turns between t = 0 and the moment when it has moved 1.2 m. "
        r"Give your answer in rad, to three significant figures, inside \boxed{}."
    )
    found, _ = solve_prompt(prompt)
    assert "As $s < d$, the pipe covers the distance $d$ only later." in found.text
    assert found.text.count("From then on it rolls, which on level ground needs no friction") == 1


def test_the_acceleration_without_slip_has_a_direction() -> None:
    """The acceleration of the shell is positive up the slope, but that of rolling without slipping is down it."""
    assert r"2.8507\ \text{m/s}^2$ down the slope. This takes the friction" in solution_text(
        "rolling-hard-choice-301929-0"
    )


def test_the_whole_angle_through_which_something_turns_is_named() -> None:
    text = solution_text("rolling-medium-multipart-301929-0")
    said = (
        "Then the angular velocity is constant, so the radius of the pipe times the angle through which it has turned"
    )
    assert said in text


def test_an_angular_momentum_is_about_a_point() -> None:
    text = solution_text("rolling-hard-multipart-301929-0")
    assert "The magnitude of the angular momentum of the hoop about its centre of mass is" in text
