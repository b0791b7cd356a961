"""Tests of balls thrown from the ground, from rest, straight down, and at any speed."""

from math import cos, radians, sin, sqrt

import pytest

from sim2reason.datasets.scene_questions import solve
from sim2reason.errors import SceneError
from sim2reason.figures.drawing import drawing
from sim2reason.scenes.dsl.scene import Scene
from sim2reason.scenes.files import dump, loads
from sim2reason.simulation.scenes import certify
from sim2reason.text.parsing import parse_scene
from sim2reason.text.prose import describe

G = 9.8
Numbers = dict[str, float | str]
GROUND: Numbers = {"height": 0.0, "speed": 20.0, "angle": 40.0}
UP: Numbers = {"height": 0.0, "speed": 20.0, "angle": 90.0}
DROPPED: Numbers = {"height": 5.0}
DOWN: Numbers = {"height": 5.0, "speed": 20.0, "angle": 90.0, "side": "below"}
SHELL: Numbers = {"height": 0.0, "speed": 2000.0, "angle": 45.0}
FAST: Numbers = {"height": 100.0, "speed": 1e7, "angle": 0.0}
ALL = [GROUND, UP, DROPPED, DOWN, SHELL, FAST, {**GROUND, "restitution": 0.5}, {**DROPPED, "restitution": 0.5}]


def thrown(numbers: Numbers) -> Scene:
    """Return a scene with a ball."""
    given = ", ".join(f"{name}: {value}" for name, value in numbers.items())
    return loads(f"scene: {{entities: [{{name: it, type: Projectile, parameters: {{ball: {{mass: 0.2}}, {given}}}}}]}}")


@pytest.mark.parametrize("numbers", ALL)
def test_it_is_written_told_read_drawn_and_certified(numbers: Numbers) -> None:
    """All usual textbook starts are covered."""
    scene = thrown(numbers)
    assert loads(dump(scene)) == scene
    for seed in range(3):
        description = describe(scene, seed)
        assert parse_scene(description.text).scene.entities[0].entity == scene.entities[0].entity, description.text
    assert {label.subject for label in drawing(scene, describe(scene)).labels if label.name} == {"it.ball"}
    trace, certificate = certify(scene)
    assert certificate.stable_until == trace.stable_until
    assert certificate.reason in ("", "limit", "crowd")


@pytest.mark.parametrize(
    ("numbers", "find", "when", "answer"),
    [
        (GROUND, "displacement", "landed", 400.0 * sin(radians(80.0)) / G),
        (GROUND, "time", "landed", 40.0 * sin(radians(40.0)) / G),
        (GROUND, "speed", "highest point", 20.0 * cos(radians(40.0))),
        (GROUND, "greatest height", "landed", (20.0 * sin(radians(40.0))) ** 2 / (2.0 * G)),
        (UP, "time", "landed", 40.0 / G),
        (UP, "velocity", "0.1 s", 20.0 - 0.1 * G),
        (DROPPED, "time", "landed", sqrt(10.0 / G)),
        (DROPPED, "velocity", "landed", sqrt(10.0 * G)),
        (DOWN, "velocity", "landed", sqrt(400.0 + 10.0 * G)),
        (DOWN, "time", "landed", (sqrt(400.0 + 10.0 * G) - 20.0) / G),
        (SHELL, "displacement", "landed", 4e6 / G),
        (FAST, "displacement", "landed", sqrt(1e14 * 200.0 / G + 1e4)),
    ],
)
def test_it_is_asked_about_and_solved_in_steps(numbers: Numbers, find: str, when: str, answer: float) -> None:
    """Answers agree with closed forms, and the solution's formulas omit what is zero."""
    found = solve(thrown(numbers), find=find, when=when)
    assert found.answer == pytest.approx(answer, rel=1e-9)
    assert found.solution.text, found.solution.reason
    assert r"10^{-16}" not in found.solution.text


def test_a_speed_of_zero_is_a_start_from_rest() -> None:
    """The launch angle has no influence at zero speed."""
    assert thrown({"height": 5.0, "speed": 0.0, "angle": 30.0}) == thrown(DROPPED)


@pytest.mark.parametrize(
    ("numbers", "said"),
    [
        ({"height": 0.0}, "on the ground it can only be thrown upwards; give a height"),
        ({"height": 0.0, "speed": 1.0, "angle": 0.0}, "on the ground it can only be thrown upwards"),
        ({"height": 1.0, "speed": 1.0}, "speed, angle: one is given without the other; give both"),
        ({"height": 1.0, "angle": 1.0}, "speed, angle: one is given without the other; give both"),
        ({"height": 1.0, "side": "below"}, "a ball released or thrown horizontally is not thrown below"),
        ({"height": 1.0, "speed": 4e7, "angle": 1.0}, "more than 30000000.0"),
    ],
)
def test_what_can_not_be_is_refused_in_words(numbers: Numbers, said: str) -> None:
    with pytest.raises(SceneError, match=said):
        thrown(numbers)
