"""Tests of questions about a given scene."""

from pathlib import Path

import pytest

from plain_scenes import atwood, ramp, swing
from sim2reason.datasets.scene_questions import ask, ask_scene
from sim2reason.generation.item import Item
from sim2reason.generation.splits import problem
from sim2reason.scenes.files import load


@pytest.fixture(scope="module")
def of_a_pendulum() -> list[Item]:
    """Return eight items about a pendulum, more than there are distinct problems."""
    return ask(swing(), items=8, seed=9)


def test_variants_of_a_problem_only_fill_up(of_a_pendulum: list[Item]) -> None:
    """A pendulum has few problems, each of which comes before any variant with other numbers."""
    found = [problem(item) for item in of_a_pendulum]
    distinct = len(set(found))
    assert len(found) == 8
    assert 3 < distinct < len(found)
    assert len(set(found[:distinct])) == distinct


def test_easy_questions_are_asked_where_there_are_no_others() -> None:
    """One law answers every question about a block on a smooth slope."""
    scene = ramp(mass=2.0, angle=30.0, friction=0.0)
    found = ask_scene(scene, "numeric", 3, 0)
    assert len(found.found) == 3
    assert found.refused["few laws"]


def test_no_two_questions_have_one_answer(of_a_pendulum: list[Item]) -> None:
    """Another wording does not make another question."""
    answers = [item.answer.shown for item in of_a_pendulum]
    assert len(set(answers)) == len(answers)


def test_no_threshold_is_asked_twice() -> None:
    """The least mass for which one block does not rise is the greatest for which the other does not."""
    items = ask(atwood(5.1, 5.0), items=40, all=True)
    answers = [item.answer.shown for item in items if item.answer.unit == "kg"]
    assert sorted(answers) == ["5 kg", "5.1 kg"]
    assert len(items) == 40


def test_unfiltered_more_can_be_asked() -> None:
    """Without filters a block that slides to rest has more, plainer questions, all about its motion."""
    scene = ramp(angle=0.0, friction=0.05, speed=5.0)
    found = ask(scene, items=8, all=True)
    assert len(found) == 8
    assert any("comes to rest" in item.prompt or "come to rest" in item.prompt for item in found)


def test_what_leaves_nothing_to_ask_is_told_why() -> None:
    """The reason is that nothing holds a massless part."""
    scene = load((Path(__file__).parents[2] / "examples/olympiad/fma_2024_17.yaml").read_text())
    assert "nothing holds a massless part" in ask_scene(scene, "numeric", 3, 0).reason


FACING = """
scene:
  name: planes
  entities:
  - name: lower
    type: StackedMassPlane
    parameters: {plane: {angle: 30.0, friction: 0.0}, lower: {mass: 2.0}, upper: {mass: 1.0}, friction: 0.3}
  - name: upper
    type: StackedMassPlane
    parameters: {plane: {angle: 30.0, friction: 0.0}, lower: {mass: 1.5}, upper: {mass: 0.7}, friction: 0.3}
  connections:
  - spring: [{entity: lower, direction: lower_right}, {entity: upper, direction: lower_left}]
    stiffness: 120.0
    free: 0.5
    strained: stretched
    by: 0.1
"""


def test_an_angle_that_a_straight_spring_fixes_is_not_asked_for() -> None:
    """Both slopes have this angle, since the spring could not be straight with another."""
    scene = load(FACING)
    found = ask(scene, mode="reverse", items=3, all=True)
    assert found
    assert all("the angle" not in item.prompt.partition("Find")[2] for item in found)
