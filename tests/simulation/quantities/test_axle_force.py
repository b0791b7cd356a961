"""Tests of the force of a fixed axle, against textbook results for rods and a sum over an arm's pieces."""

from collections.abc import Sequence
from math import cos, hypot, radians, sin, sqrt

import pytest

from sim2reason.questions.following import simulate_scene
from sim2reason.questions.posing import pose_question
from sim2reason.questions.prompt import words_of
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.scenes.bodies.oscillators import Ball, FixedBall, LightRod, UniformRod
from sim2reason.scenes.bodies.round_bodies import Sphere
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.pendulums import Pendulum, RotationEntity
from sim2reason.scenes.entities.pieces import AxialPiece, BallPiece, RoundPiece, WeldedPiece
from sim2reason.simulation.quantities import QUANTITIES
from sim2reason.text.prose.description import describe

G, MASS, LENGTH = 9.8, 2.0, 0.6
ROD = AxialPiece(body=UniformRod(mass=MASS, length=LENGTH), axis="along the arm", distance=LENGTH / 2.0)
SPHERE = RoundPiece(body=Sphere(mass=2.3, radius=0.12), distance=0.2)
BALL = BallPiece(body=FixedBall(mass=3.1), distance=0.35, side="on the other side")


def armed(pieces: Sequence[WeldedPiece], angle: float, rate: float | None = None) -> Scene:
    arm = RotationEntity(pieces=tuple(pieces), angle=angle, rate=rate)
    return Scene(entities=(Named(name="arm", entity=arm),))


def found(scene: Scene, when: str, along: str = "", find: str = "axle force") -> float:
    """Return the force in N, or its component along a direction."""
    motion, words = simulate_scene(scene), words_of(describe(scene))
    of = "the arm" if find != "force on the axle" else "arm.arm"
    answer = pose_question(StructuredQuestion(find, of, when, along), motion, words).simulate_answer(motion).answer
    assert answer is not None
    return answer


def test_a_rod_on_an_axle_at_its_end_let_go_from_level_weighs_a_quarter_at_first() -> None:
    """The initial force is mg/4.

    Halliday, Resnick and Walker, *Fundamentals of Physics*, chapter 10: α = 3g/2L.
    """
    scene = armed([ROD], 90.0)
    assert found(scene, "at start") == pytest.approx(0.25 * MASS * G, rel=1e-9)
    assert found(scene, "at start", "vertical") == pytest.approx(0.25 * MASS * G, rel=1e-9)
    assert found(scene, "at start", "horizontal") == pytest.approx(0.0, abs=1e-9)


def test_it_pulls_with_five_halves_of_its_weight_at_the_lowest_point() -> None:
    """The force is mg + m ω² L/2 with ω² = 3g/L.

    Kleppner and Kolenkow, *An Introduction to Mechanics*, chapter 7.
    """
    scene = armed([ROD], 90.0)
    assert found(scene, "the rod lowest point") == pytest.approx(2.5 * MASS * G, rel=1e-8)
    assert found(scene, "the rod lowest point", "vertical") == pytest.approx(2.5 * MASS * G, rel=1e-8)
    assert found(scene, "whole motion", find="greatest axle force") == pytest.approx(2.5 * MASS * G, rel=1e-8)


def test_a_rod_from_rest_at_some_angle_obeys_the_formulas_of_the_falling_rod() -> None:
    """With ω² = 3g (cos θ − cos θ₀)/L, F_r = mg (5 cos θ − 3 cos θ₀)/2 and F_t = mg (sin θ)/4."""
    scene, now = armed([ROD], 80.0), radians(80.0 - 50.0)
    inward, aside = 0.5 * (5.0 * cos(now) - 3.0 * cos(radians(80.0))), 0.25 * sin(now)
    weight, when = MASS * G, "the arm turned through 50"
    assert found(scene, when) == pytest.approx(weight * hypot(inward, aside), rel=1e-8)
    assert found(scene, when, "vertical") == pytest.approx(weight * (inward * cos(now) + aside * sin(now)), rel=1e-8)
    right = weight * (aside * cos(now) - inward * sin(now))
    assert found(scene, when, "horizontal") == pytest.approx(right, rel=1e-8)


def test_it_is_the_sum_over_the_pieces_on_both_sides_of_the_axle() -> None:
    """The force on a turning arm is Σ m (a − g) with a = α × r − ω² r of each piece.

    The heavier piece is beyond the axle.
    """
    inertia = 2.3 * (0.4 * 0.12**2 + 0.2**2) + 3.1 * 0.35**2
    moment, angle, rate = 2.3 * 0.2 - 3.1 * 0.35, radians(70.0), 3.0
    growth = -moment * G * sin(angle) / inertia
    right = moment * (growth * cos(angle) - rate**2 * sin(angle))
    up = moment * (growth * sin(angle) + rate**2 * cos(angle)) + (2.3 + 3.1) * G
    scene = armed([SPHERE, BALL], 70.0, rate)
    assert found(scene, "at start", "horizontal") == pytest.approx(right, rel=1e-9)
    assert found(scene, "at start", "vertical") == pytest.approx(up, rel=1e-9)
    assert found(scene, "at start") == pytest.approx(hypot(right, up), rel=1e-9)
    assert found(scene, "at start", find="force on the axle") == pytest.approx(hypot(right, up), rel=1e-9)


def test_of_a_swing_that_goes_round_it_is_greatest_below() -> None:
    rate = 12.0
    square = rate**2 + 3.0 * G / LENGTH * (1.0 - cos(radians(60.0)))
    scene = armed([ROD], 60.0, rate)
    greatest = MASS * (G + 0.5 * LENGTH * square)
    assert sqrt(square) > sqrt(6.0 * G / LENGTH)  # enough to go over the top
    assert found(scene, "whole motion", find="greatest axle force") == pytest.approx(greatest, rel=1e-8)


def test_a_light_rod_with_a_ball_at_its_end_has_a_rod_force_instead() -> None:
    """The two forces are the same, so a problem should offer only one."""
    swing = Pendulum(bob=Ball(mass=0.3), hanger=LightRod(length=0.9), angle=30.0, speed=1.0)
    mechanism = Scene(entities=(Named(name="swing", entity=swing),)).mechanism
    assert not QUANTITIES["axle force"].subjects(mechanism)
    assert QUANTITIES["rod force"].subjects(mechanism) == ("swing.hanger",)
