"""Tests of solutions about bouncing balls and about pucks on a tilted table."""

from math import cos, radians, sin, sqrt

import pytest

from sim2reason.generation.make import make
from sim2reason.generation.request import Request
from sim2reason.questions import Query, Target
from sim2reason.questions.kinds.stretches import StretchQuery
from sim2reason.questions.moments.bounces import Bounced
from sim2reason.questions.moments.distances import Away
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from worked import derived

BALL, G = "field.ball", 9.8


def scene(angle: float, speed: float = 4.4) -> Scene:
    entity = Projectile(ball=Ball(mass=1.4), height=2.2, speed=speed, angle=angle, restitution=0.44)
    return Scene(entities=(Named(name="field", entity=entity),))


def test_an_impact_on_smooth_ground_keeps_the_horizontal_velocity_which_is_said_once() -> None:
    found = derived(scene(40.0), Query("event", Target("displacement", BALL), Bounced(BALL, number=3)))
    assert found.text.count("its velocity along x stays the same") == 1
    assert found.text.index("stays the same") < found.text.index("the displacement is $s_x")


def test_a_change_along_one_axis_has_no_other_component() -> None:
    found = derived(scene(40.0), StretchQuery("sum", None, Bounced(BALL, number=2), "impulse of the net force", BALL))
    assert "along y; the other component is zero." in found.text


@pytest.mark.parametrize("angle", [0.0, 40.0, 75.0])
def test_the_first_time_at_a_distance_is_not_before_the_bounce(angle: float) -> None:
    found = derived(scene(angle), Query("time_to_event", None, Away(BALL, 5.2 if angle < 70.0 else 2.9)))
    assert "Until $t$ the horizontal displacement of the ball is at most $s_x$" in found.text
    seen = {r.left.latex(): float(r.right.value(found.values).real) for r in found.relations if r.role == "verified"}
    up, along = 4.4 * sin(radians(angle)), 4.4 * cos(radians(angle))
    lands = (up + sqrt(up * up + 2.0 * G * 2.2)) / G
    assert seen[r"d_{\text{max}}"] == pytest.approx(sqrt((along * lands) ** 2 + 2.2**2))
    assert any(r.role == "exceeds" and r.left.latex() == "d" for r in found.relations)
    assert ("it never rises above its starting point" in found.text) == (angle == 0.0)
    if angle:
        assert seen[r"s_{\text{top}}"] == pytest.approx(up * up / (2.0 * G))


def test_a_bounce_that_a_motion_does_not_reach_is_no_error() -> None:
    """One draw asks for the restitution of a motion that ends before its second bounce."""
    assert make(Request("projectile", "easy", "reverse", 3232, 0)).item is not None
