"""Tests of standard textbook problems against independent closed forms."""

from dataclasses import replace
from math import cos, radians, sin, sqrt

import numpy as np
import pytest

from plain_scenes import G, atwood, ramp
from sim2reason.questions import Query, Target
from sim2reason.questions.moments.contacts import Collided
from sim2reason.questions.moments.turning_points import HighestPoint, LowestPoint
from sim2reason.scenes.bodies.blocks import Puck, Table
from sim2reason.scenes.bodies.oscillators import Ball
from sim2reason.scenes.dsl.entity import Named
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.entities.particles import Projectile
from sim2reason.scenes.entities.two_d_collision_plane import TwoDCollisionPlane
from sim2reason.solutions import Solution, solve, solve_prompt
from sim2reason.testing.solution_verification import faults
from worked import answer, asked, problems


def solved(scene: Scene, question: str | Query) -> Solution:
    setting = asked(scene, question)
    found = solve(setting)
    assert found.answer is not None, found.reason
    assert setting.answer is not None
    assert not faults(found, setting.answer), found.text
    return found


def test_an_atwood_machine() -> None:
    found = solved(atwood(3.0, 2.0), "What is the tension in the string just after release?")
    assert found.answer == pytest.approx(2.0 * 3.0 * 2.0 * G / 5.0)
    assert r"$T - m_B g = m_B a$" in found.text


def test_a_block_that_slides_down_a_rough_ramp() -> None:
    found = solved(ramp(angle=40.0, friction=0.2), "What is the speed of the block 0.50 s after release?")
    assert found.answer == pytest.approx(0.5 * G * (sin(radians(40.0)) - 0.2 * cos(radians(40.0))))


def test_a_block_thrown_up_a_ramp_that_comes_back_slower() -> None:
    """The acceleration is g (sin + µ cos) on the way up and g (sin − µ cos) on the way down."""
    scene, steep, rub = ramp(angle=40.0, friction=0.2, speed=3.0), sin(radians(40.0)), 0.2 * cos(radians(40.0))
    found = solved(scene, "What is the speed of the block at t = 1.0 s?")
    up = 3.0 / (G * (steep + rub))
    assert found.answer == pytest.approx(G * (steep - rub) * (1.0 - up))


def test_a_distance_is_found_without_forces() -> None:
    found = solved(atwood(), "How far is block B from its starting point after block A has moved 0.50 m?")
    assert found.answer == pytest.approx(0.5)
    assert "g" not in {name for relation in found.relations for name in relation.symbols()}


def test_two_pucks_that_meet_aside() -> None:
    """The pucks meet when their centres are 2 R apart; only velocities along the line of centres change."""
    pucks = (Puck(mass=1.0, x=0.0, y=0.0, vx=2.0, vy=0.3), Puck(mass=2.0, x=1.0, y=0.1, vx=0.0, vy=0.0))
    entity = TwoDCollisionPlane(table=Table(), radius=0.1, pucks=pucks, restitution=0.5)
    scene = Scene(entities=(Named(name="table", entity=entity),))
    moment = Collided("table.pucks.0 & table.pucks.1")
    found = solved(scene, Query("event", Target("velocity", "table.pucks.1"), moment))
    apart, closing = np.array([1.0, 0.1]), np.array([2.0, 0.3])
    time = min(np.roots([closing @ closing, -2.0 * closing @ apart, apart @ apart - 0.2**2]).real)
    normal = (apart - time * closing) / 0.2
    assert found.answer == pytest.approx(1.5 / 3.0 * float(closing @ normal))


def test_a_prompt_alone_is_solved_in_its_own_names() -> None:
    from sim2reason.datasets.items import item

    items = (item("pulley", "easy", seed=5, index=index) for index in range(20))
    held = next(each for each in items if each.kind in ("state", "start", "event", "time_to_event"))
    found, setting = solve_prompt(held.prompt)
    assert found.answer == pytest.approx(held.answer.value, rel=1e-9)
    assert all(noun in held.prompt.lower() for noun in ("block", "crate") if noun in found.text.lower())
    assert setting.words.mentions.values()


@pytest.mark.parametrize("angle", [17.0, 40.0, 72.0])
def test_a_throw_is_highest_after_v_sin_over_g(angle: float) -> None:
    thrown = Projectile(ball=Ball(mass=0.3), height=2.0, speed=5.0, angle=angle)
    found = answer("throw", thrown, Query("time_to_event", None, HighestPoint("throw.ball")))
    assert found == pytest.approx(5.0 * sin(radians(angle)) / G)


def test_the_time_for_a_distance_from_rest() -> None:
    found = solved(ramp(angle=30.0), "How long does the block take to move 0.80 m, counted from release?")
    assert found.answer == pytest.approx(sqrt(2.0 * 0.8 / (G / 2.0)))


def test_what_a_string_pulls_at_the_lowest_point() -> None:
    """T = m g (3 − 2 cos θ₀) + m v₀²/ℓ, which is three times the weight after a release from level."""
    checked = 0
    for setting in problems("pendulum", "easy", 12, seed=5):
        swing = setting.scene.entities[0].entity
        query = Query("event", Target("tension", "pendulum.hanger"), LowestPoint("pendulum.bob"))
        lone = {name.split(".")[-1] for name in setting.mechanism.body} == {"bob"}
        if not lone or setting.study.time(query.moment) is None:  # type: ignore[arg-type]
            continue
        mass, angle = getattr(getattr(swing, "bob"), "mass"), radians(getattr(swing, "angle"))  # noqa: B009
        length, speed = getattr(getattr(swing, "hanger"), "length"), getattr(swing, "speed") or 0.0  # noqa: B009
        found = solve(replace(setting, query=query))
        assert found.answer == pytest.approx(mass * (G * (3.0 - 2.0 * cos(angle)) + speed**2 / length))
        checked += 1
    assert checked
