"""Tests of questions about changes between two moments, sums over everything, and multiples of initial values."""

from math import radians, sin
from pathlib import Path

import pytest

from sim2reason.errors import TextError
from sim2reason.questions.following import simulate_scene
from sim2reason.questions.ordinary.turns_of_order import without_asides
from sim2reason.questions.ordinary.understanding import understand_sentence
from sim2reason.questions.prompt import words_of
from sim2reason.scenes.files import load
from sim2reason.text.prose.description import describe

DATA = Path(__file__).parents[2] / "data"


def answer(name: str, question: str) -> float | None:
    """Return the answer to a question in ordinary English."""
    path = next(DATA.glob(f"*_scenes/{name}.yaml"))
    motion, words = simulate_scene(load(path)), words_of(describe(load(path)))
    found = understand_sentence(question, motion, words)
    return found.simulated_answer.answer if found is not None else None


@pytest.mark.parametrize(
    ("name", "question", "value"),
    [
        ("bounce", "How much time passes between the first and the second bounce?", 1.6 * (10.0 / 9.8) ** 0.5),
        ("bounce", "How long after the first bounce does the second one follow?", 1.6 * (10.0 / 9.8) ** 0.5),
        ("bounce", "How far apart are the first and the second landing points?", 4.8 * (10.0 / 9.8) ** 0.5),
        ("bounce", "How high does the ball rise between the first and the second bounce?", 3.2),
        ("bounce", "How much energy does the ball lose in the first bounce?", 0.36 * 9.8),
        ("bounce", "By how much does the kinetic energy of the ball increase in the first 0.5 s?", 0.1 * 4.9**2),
    ],
)
def test_differences_are_those_of_two_moments(name: str, question: str, value: float) -> None:
    """A ball of 0.2 kg is thrown horizontally at 3 m/s from 5 m, and bounces with 0.8 of its vertical speed."""
    assert answer(name, question) == pytest.approx(value, rel=1e-6)


@pytest.mark.parametrize(
    ("name", "question", "value"),
    [
        ("brief_climb", "Find the acceleration of the block while it slides down.", 3.530194083),
        ("three_hung", "Determine the tension in the string that carries the pulley P.", 27.2034482759),
        ("smooth_box", "What is the total kinetic energy of the system when A has slid 0.50 m along the box?", 9.8),
        ("coasting_disc", "When has the disc's speed doubled?", 4.4 / (2.0 / 3.0 * 9.8 * sin(radians(29.0)))),
        ("coasting_disc", "How many revolutions does the disc make in the first 2.0 s?", 35.9520224897),
    ],
)
def test_more_than_one_state_or_body_is_looked_at(name: str, question: str, value: float) -> None:
    assert answer(name, question) == pytest.approx(value, rel=1e-6)


def test_a_loss_that_is_a_gain_is_refused() -> None:
    """A question is refused if it presumes something false."""
    with pytest.raises(TextError, match="the other way round"):
        answer("bounce", "By how much does the kinetic energy of the ball decrease in the first 0.5 s?")


@pytest.mark.parametrize(
    ("told", "plain"),
    [
        ("how fast is @0@ , as seen from floor , when @0@ stops", "how fast is @0@ when @0@ stops"),
        ("what is speed of @0@ . give its magnitude", "what is speed of @0@"),
        ("how heavy (in kg) would @0@ have to be", "how heavy would @0@ have to be"),
        ("what is period of oscillation that follows", "what is period of oscillation"),
        ("how fast is @0@ at first instant when @0@ stops", "how fast is @0@ when @0@ stops"),
    ],
)
def test_asides_are_passed_over(told: str, plain: str) -> None:
    """Phrases that do not change the question are removed."""
    assert without_asides(told) == plain


@pytest.mark.parametrize(
    "told",
    ["how fast is @0@ as seen from @1@", "how fast is @0@ relative to @1@", "how fast is @0@ after first collision"],
)
def test_what_matters_is_no_aside(told: str) -> None:
    """Phrases that name a moving frame or an event stay."""
    assert without_asides(told) == told
