"""Tests of questions in ordinary English about a changed scene, or for a number that causes an outcome."""

from functools import cache
from math import cos, radians, sin
from pathlib import Path
from time import perf_counter

import pytest

from sim2reason.errors import TextError
from sim2reason.questions.following import FollowedMotion, simulate_scene
from sim2reason.questions.ordinary.hearing import tokenize
from sim2reason.questions.ordinary.understanding import understand_sentence
from sim2reason.questions.posing import pose_question
from sim2reason.questions.prompt import words_of
from sim2reason.questions.structured import StructuredQuestion
from sim2reason.questions.words import Words
from sim2reason.scenes.files import load
from sim2reason.text.prose.description import describe

SCENES = Path(__file__).parents[2] / "data" / "ordinary_scenes"


@cache
def scene(name: str) -> tuple[FollowedMotion, Words]:
    """Return the motion of a scene, and its words."""
    held = load(SCENES / f"{name}.yaml")
    return simulate_scene(held), words_of(describe(held))


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
    """The structured question that is shown has the same answer."""
    motion, words = scene(name)
    found = understand_sentence(question, motion, words)
    assert found is not None
    assert found.simulated_answer.answer is not None
    assert pose_question(found.asked, motion, words).simulate_answer(motion).answer == pytest.approx(
        found.simulated_answer.answer, rel=1e-9
    )


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
    """The error says that several values are possible, or that a presupposition is false."""
    with pytest.raises(TextError, match=told):
        understand_sentence(question, *scene(name))


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
    """A question is not understood if any word of it has no meaning."""
    assert understand_sentence(question, *scene("doubled_load")) is None


@pytest.mark.parametrize("part", ["a and ", "A, B, ", "g were 5 m/s² and "])
def test_a_long_list_of_suppositions_takes_little_time(part: str) -> None:
    """The time grows as a power of the number of parts, not exponentially."""
    asked = f"{'If ' + part * 60:.350}, what is the acceleration of A?"
    began = perf_counter()
    assert understand_sentence(asked, *scene("doubled_load")) is None
    assert perf_counter() - began < 5.0


def test_small_oscillations_have_a_period_whatever_the_motion_is() -> None:
    """A pendulum's mode of small oscillations has a period, although this one swings through large angles."""
    found = understand_sentence(
        "What would be the period if the arm were only swinging through small angles?", *scene("swung_sphere")
    )
    assert found is not None
    assert found.simulated_answer.answer == pytest.approx(1.0882796185, rel=1e-8)


@pytest.mark.parametrize(
    ("name", "question", "answer"),
    [
        ("hung_load", "What coefficient of friction would halve the acceleration of the blocks?", 0.5795023570),
        ("hung_load", "How much heavier would B have to be for the acceleration to be doubled?", 2.8119180877),
        (
            "hung_load",  # T = m_A g with a = g (1 − m_A/m_B): µ = (m_A/m_B − sin θ)/cos θ
            "What would the coefficient of friction have to be for the tension in the string to be A's weight?",
            (2.2 / 3.0 - sin(radians(36.0))) / cos(radians(36.0)),
        ),
        (
            "trolley_at_wall",
            "What speed must the blow give the trolley to compress the spring by at most 0.40 m?",
            2.7301918,
        ),
        (
            "field_circle",
            "At what speed would the bead have to be launched for its circle to have a radius of 5.0 m?",
            1.25,
        ),
        ("spring_and_load", "At what starting length of the spring would the blocks stay at rest?", 0.6416666667),
        ("lob", "To land 5.0 m away, at what speed would the ball have to be thrown?", 7.5973528427),
        ("spring_and_load", "If the spring were half as stiff, how far down would B go?", 0.2666666667),
    ],
)
def test_a_number_is_found_by_what_it_brings_about(name: str, question: str, answer: float) -> None:
    """The condition may be a multiple, a bound or an initial wish, and an adjective may name the number."""
    found = understand_sentence(question, *scene(name))
    assert found is not None
    assert found.simulated_answer.answer == pytest.approx(answer, rel=1e-6)


@pytest.mark.parametrize(
    ("name", "question", "told"),
    [
        ("two_planets", "What is the least initial speed for planet B to remain bound to the star?", "the other side"),
        ("two_planets", "Above what mass of the star would planet A escape?", "the other side"),
        (
            "hung_load",
            "Suppose the string is cut after 0.50 s. How far does A slide before it stops?",
            "not clear what follows",
        ),
        ("two_springs", "What initial speed of A would make spring 2 be compressed by 0.25 m at most?", "no longer"),
        ("hung_load", "What coefficient of friction would make the tension be B's weight?", "a whole range"),
    ],
)
def test_why_a_number_is_not_found_is_said(name: str, question: str, told: str) -> None:
    """The error gives the other end of the range, a second motion, or the limit of work."""
    with pytest.raises(TextError, match=told):
        understand_sentence(question, *scene(name))


def test_what_is_to_move_meanwhile_does() -> None:
    """A mass with which B stays at rest does not satisfy *while B falls*."""
    asked = "How heavy would B have to be for A to stay at rest while B falls?"
    assert understand_sentence(asked, *scene("spring_and_load")) is None


def test_a_number_is_no_name_of_a_spring() -> None:
    """The digit 2 of *2.5 m/s* does not mean spring 2."""
    heard = tokenize("If A were started at 2.5 m/s, how fast would B be?", scene("two_springs")[1])
    assert heard.numbers == ("2.5 m/s",)


def test_a_result_names_a_quantity_whose_name_has_an_of() -> None:
    """A structured question may give the radius of the path."""
    motion, words = scene("field_circle")
    parts = {"find": "fields.start.speed", "given": "radius of the path of the bead = 5.0 m"}
    found = pose_question(StructuredQuestion.read(parts), motion, words).simulate_answer(motion).answer
    assert found == pytest.approx(1.25, rel=1e-9)


@pytest.mark.parametrize(
    ("name", "question", "reason"),
    [
        (
            "barely_rough_haul",
            "Suppose the plane were smoother. What is the least coefficient of friction with which A stays at rest?",
            "changes the other way",
        ),
        (
            "light_slope_load",
            "To what value would the mass of B have to be raised for the blocks just to stay at rest when let go?",
            "changes the other way",
        ),
    ],
)
def test_the_told_direction_of_a_change_must_be_right(name: str, question: str, reason: str) -> None:
    """A smoother plane, or a heavier block, would have the opposite effect."""
    with pytest.raises(TextError, match=reason):
        understand_sentence(question, *scene(name))


def test_of_several_values_that_which_the_sentence_tells_is_meant() -> None:
    """Both a heavier and a lighter block C meet the condition, and the sentence names one of them."""
    asked = "Suppose C is replaced by a {} block. What mass must it have so that A accelerates at 1.5 m/s² relative to"
    heavier = understand_sentence(f"{asked.format('heavier')} the box?", *scene("loads_on_both_sides"))
    lighter = understand_sentence(f"{asked.format('lighter')} the box?", *scene("loads_on_both_sides"))
    assert heavier is not None
    assert lighter is not None
    assert heavier.simulated_answer.answer == pytest.approx(4.965106257, rel=1e-6)
    assert lighter.simulated_answer.answer == pytest.approx(2.09706, rel=1e-4)


@pytest.mark.parametrize("asked", ["What magnetic field would make the period 2.0 s?"])
def test_a_number_from_a_stated_period_is_found_in_time(asked: str) -> None:
    """B = 2πm/(qT); no motion is followed for longer than the period at a nearby value."""
    begun = perf_counter()
    found = understand_sentence(asked, *scene("plain_gyration"))
    assert found is not None
    assert found.simulated_answer.answer == pytest.approx(3.316125580526, rel=1e-9)
    assert perf_counter() - begun < 6.0  # more than thirty times what it takes beside the patterns' compilation
