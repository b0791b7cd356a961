"""Questions in ordinary English about a changed scene, and for a number that makes something so."""

from functools import cache
from pathlib import Path

import pytest

from sim2reason.errors import TextError
from sim2reason.prose.description import describe
from sim2reason.questions.following import FollowedMotion, motion_of
from sim2reason.questions.ordinary.understanding import understood
from sim2reason.questions.posing import posed
from sim2reason.questions.prompt import words_of
from sim2reason.questions.words import Words
from sim2reason.scene_files import load

SCENES = Path(__file__).parents[2] / "data" / "ordinary_scenes"


@cache
def scene(name: str) -> tuple[FollowedMotion, Words]:
    """Return the motion of a scene, and its words."""
    held = load(SCENES / f"{name}.yaml")
    return motion_of(held), words_of(describe(held))


@pytest.mark.parametrize(
    ("name", "question"),
    [
        ("doubled_load", "By what factor would the acceleration increase if the mass of B were doubled?"),
        ("doubled_load", "How heavy would B have to be for A to accelerate at 2.0 m/s² up the slope?"),
        ("recoiling_box", "If the box were held fixed, what would the acceleration of A be?"),
        ("low_throw", "What launch speed, at the same angle, would make the ball land 15 m away?"),
        ("escaping_planet", "By how much would the planet's speed at t = 0 have to be greater for it to escape?"),
        ("heavy_probe", "What is the lowest burn rate at which the probe lifts off at once?"),
        ("climbing_disc", "What coefficient of static friction is needed at least if the disc is not to slip?"),
        ("full_circle", "With what speed must the ball be launched to go all the way round with the string taut?"),
    ],
)
def test_the_parts_of_what_is_understood_have_its_answer(name: str, question: str) -> None:
    """The structured question that is shown leads to the same answer."""
    motion, words = scene(name)
    found = understood(question, motion, words)
    assert found is not None
    assert found.followed.answer is not None
    assert posed(found.asked, motion, words).followed(motion).answer == pytest.approx(found.followed.answer, rel=1e-9)


@pytest.mark.parametrize(
    ("name", "question", "told"),
    [
        ("low_throw", "At what angle would the ball have to be thrown to land 8 m away?", "several values do"),
        ("doubled_load", "By how much would the tension increase if the mass of A were halved?", "the other way"),
        ("escaping_planet", "By what factor must the planet's speed be smaller for it to escape?", "in two ways"),
        (
            "doubled_load",
            "What would the tension in the string be if the plane were inclined at 700°?",
            "no such motion",
        ),
    ],
)
def test_why_there_is_no_one_answer_is_said(name: str, question: str, told: str) -> None:
    """Several values do, or it is not so."""
    with pytest.raises(TextError, match=told):
        understood(question, *scene(name))


@pytest.mark.parametrize(
    "question",
    [
        "What would the acceleration of A be if the mass of the pulley were 1 kg?",
        "What would the tension in the string be if B were not twice as heavy?",
        "If the mass of B were doubled twice, what would the acceleration of A be?",
        "What would the acceleration of A be if A and B were interchanged?",
        "What would the colour of A be if the mass of B were doubled?",
    ],
)
def test_a_word_without_a_place_is_refused(question: str) -> None:
    """In the supposition as in the question."""
    assert understood(question, *scene("doubled_load")) is None


def test_small_oscillations_have_a_period_whatever_the_motion_is() -> None:
    """Where there is one mode."""
    found = understood(
        "What would be the period if the arm were only swinging through small angles?", *scene("swung_sphere")
    )
    assert found is not None
    assert found.followed.answer == pytest.approx(1.0882796185, rel=1e-8)
