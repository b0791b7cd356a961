"""Tests of the size and direction of a supposed change, as the options of the structured question show them."""

from functools import cache
from pathlib import Path

import pytest

from sim2reason.questions.following import FollowedMotion, simulate_scene
from sim2reason.questions.ordinary.understanding import understand_sentence
from sim2reason.questions.prompt import words_of
from sim2reason.questions.words import Words
from sim2reason.scenes.files import load
from sim2reason.text.prose.description import describe

SCENES = Path(__file__).parents[3] / "data" / "ordinary_scenes"
MASS, ANGLE = "mass_with_fixed_pulley.system.blocks.0.mass", "two_side_mass_plane.plane.angle"


@cache
def scene(name: str) -> tuple[FollowedMotion, Words]:
    held = load(SCENES / f"{name}.yaml")
    return simulate_scene(held), words_of(describe(held))


def change(name: str, question: str) -> str:
    """Return the change that a question supposes, such as *path = 2*; empty if it is not understood."""
    found = understand_sentence(question, *scene(name))
    return "" if found is None else found.asked.options.partition("--change '")[2].partition("'")[0]


@pytest.mark.parametrize(
    ("supposed", "path", "value"),
    [
        ("the mass of B were increased by 20 %", MASS, 1.92),
        ("the mass of B were 20% larger", MASS, 1.92),
        ("the mass of B were 20 percent smaller", MASS, 1.28),
        ("the mass of B were reduced by 50%", MASS, 0.8),
        ("the mass of B were increased by 100 %", MASS, 3.2),
        ("the mass of B were increased by 0.5 %", MASS, 1.608),
        ("the mass of B were increased by 1 kg", MASS, 2.6),
        ("the mass of B were reduced by 300 g", MASS, 1.3),
        ("the mass of B were doubled", MASS, 3.2),
        ("the mass of B were halved", MASS, 0.8),
        ("the mass of B were 3 times as large", MASS, 4.8),
        ("the mass of B were 2.5 kg", MASS, 2.5),
        ("the angle were 10 degrees smaller", ANGLE, 24),
        ("the angle were 10 % larger", ANGLE, 37.4),
        ("the plane were level", ANGLE, 0),
    ],
)
def test_a_number_is_changed_by_as_much_as_is_said(supposed: str, path: str, value: float) -> None:
    """Block B has a mass of 1.6 kg, and the slope an angle of 34°."""
    place, _, number = change("doubled_load", f"What would the acceleration of A be if {supposed}?").partition(" = ")
    assert place == path
    assert float(number) == pytest.approx(value, rel=1e-12)


@pytest.mark.parametrize(
    ("way", "understood"), [("up", True), ("upwards", True), ("down", False), ("downwards", False)]
)
def test_a_ball_that_starts_upwards_is_not_thrown_down(way: str, understood: bool) -> None:
    """The angle of the throw is 23° above the horizontal, and only the speed is supposed to change."""
    asked = f"How long would the ball be in the air if it were thrown {way} at 5 m/s?"
    assert change("cliff_throw", asked) == ("throw.speed = 5" if understood else "")
