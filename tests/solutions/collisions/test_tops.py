"""Tests of extreme values in free flight against those of a parabola."""

from math import cos, radians, sin

import pytest

from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.bounces import Bounced, Landed
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.solutions import STRATEGIES, Solution, solve_with
from worked import asked, derived, solution_text

BALL, G, SPEED, ANGLE = "field.ball", 9.8, 5.2, radians(34)


def thrown(restitution: float | None) -> tuple[Scene, Bounced | Landed]:
    entity = Projectile(ball=Ball(mass=0.5), height=3.9, speed=SPEED, angle=34.0, restitution=restitution)
    lands = Landed(BALL) if restitution is None else Bounced(BALL, after=False)
    return Scene(entities=(Named(name="field", entity=entity),)), lands


def extreme(functional: str, restitution: float | None) -> Solution:
    scene, lands = thrown(restitution)
    found = derived(scene, StretchQuery("extremum", None, lands, functional, BALL))
    assert found.strategy == "impulse"
    return found


@pytest.mark.parametrize("restitution", [None, 0.5])
def test_the_greatest_height_is_that_of_the_vertical_motion(restitution: float | None) -> None:
    """The greatest height follows from the vertical motion alone; it is not the distance from the starting point."""
    found = extreme("greatest height", restitution)
    assert found.answer == pytest.approx((SPEED * sin(ANGLE)) ** 2 / (2.0 * G), rel=1e-9)
    assert "vertical velocity of the ball is zero" in found.text


@pytest.mark.parametrize("restitution", [None, 0.5])
def test_the_least_speed_is_the_horizontal_component(restitution: float | None) -> None:
    found = extreme("least speed", restitution)
    assert found.answer == pytest.approx(SPEED * cos(ANGLE), rel=1e-9)


def test_one_body_has_no_motion_relative_to_itself() -> None:
    scene, lands = thrown(None)
    setting = asked(scene, StretchQuery("extremum", None, lands, "greatest height", BALL))
    assert STRATEGIES["momentum"].why_unsuitable(scene.mechanism)
    assert solve_with(STRATEGIES["momentum"], setting).answer is None


def test_what_has_a_closed_form_is_not_said_to_be_integrated() -> None:
    scene, lands = thrown(0.5)
    setting = asked(scene, StretchQuery("extremum", None, lands, "greatest height", BALL))
    found = solve_with(STRATEGIES["integration"], setting)
    assert found.answer is not None, found.reason
    assert "numerical" not in found.text
    assert "accelerations are constant" in found.text


def test_a_puck_that_rises_again_after_a_collision_is_told_to() -> None:
    text = solution_text("collision-hard-choice-301932-0")
    told = "After the collision of pucks A and C, puck C still rises; at the highest point of the path the velocity"
    assert told in text
