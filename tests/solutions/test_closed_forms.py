"""Problems of every textbook, their closed forms written down here independently."""

from math import cos, radians, sin, sqrt

import pytest

from plain_scenes import G, atwood, ramp, table
from sim2reason.dsl.scene import Scene
from sim2reason.questions import Query, Target
from sim2reason.questions.moments.collided import Collided
from sim2reason.solutions import Solution, solve, solve_prompt
from sim2reason.solutions.check import faults
from worked import asked, problems


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
    """Up with g (sin + µ cos), down with g (sin − µ cos)."""
    scene, steep, rub = ramp(angle=40.0, friction=0.2, speed=3.0), sin(radians(40.0)), 0.2 * cos(radians(40.0))
    found = solved(scene, "What is the speed of the block at t = 1.0 s?")
    up = 3.0 / (G * (steep + rub))
    assert found.answer == pytest.approx(G * (steep - rub) * (1.0 - up))


def test_a_distance_is_found_without_forces() -> None:
    found = solved(atwood(), "How far is block B from its starting point after block A has moved 0.50 m?")
    assert found.answer == pytest.approx(0.5)
    assert "g" not in {name for relation in found.relations for name in relation.symbols()}


def test_two_pucks_head_on() -> None:
    """The lighter one of m and 2 m at e = ½ stops: (m − 2 e m)/(3 m)."""
    moment = Collided("table.pucks.0 & table.pucks.1")
    found = solved(table(speed=2.0), Query("event", Target("velocity", "table.pucks.1"), moment))
    assert found.answer == pytest.approx(2.0 * (1.0 + 0.5) / 3.0)


def test_a_prompt_alone_is_solved_in_its_own_names() -> None:
    from sim2reason.datasets.items import item

    held = item("pulley", "easy", seed=5, index=1)
    found, setting = solve_prompt(held.prompt)
    assert found.answer == pytest.approx(held.answer.value, rel=1e-9)
    assert all(said in held.prompt for said in ("block A", "block B") if said in found.text)
    assert setting.words.mentions.values()


def test_a_throw_is_highest_after_v_sin_over_g() -> None:
    checked = 0
    for setting in problems("projectile", "easy", 30):
        if type(setting.query.moment).__name__ != "HighestPoint" or setting.query.target is not None:
            continue
        throw = setting.scene.entities[0].entity
        found = solve(setting)
        angle, speed = radians(getattr(throw, "angle")), getattr(throw, "speed")  # noqa: B009
        assert found.answer == pytest.approx(speed * sin(angle) / G)
        checked += 1
    assert checked


def test_the_time_for_a_distance_from_rest() -> None:
    found = solved(ramp(angle=30.0), "From release on, how long does the block take to move 0.80 m?")
    assert found.answer == pytest.approx(sqrt(2.0 * 0.8 / (G / 2.0)))
