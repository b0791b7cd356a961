"""Tests of numbers in questions as people write them."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from plain_scenes import ramp
from sim2reason.questions import KINDS, SimulatedScene
from sim2reason.questions.prompt import words_of
from sim2reason.questions.sentences import parse_question, plainly
from sim2reason.questions.words import format_number, numbers_in_text, two_digits
from sim2reason.scenes.dsl.units import ASTRONOMICAL, SI
from sim2reason.text.prose.description import describe

SCENE = ramp()
STUDY, WORDS = SimulatedScene.of(SCENE, np.linspace(0.0, 1.0, 11)), words_of(describe(SCENE))


@pytest.mark.parametrize(
    ("written", "told"),
    [
        ("1 m", "1.0 m"),
        ("0.255 m", "0.255 m"),
        ("25 cm", "0.25 m"),
        ("half a metre", "0.50 m"),
        ("a quarter of a second", "0.25 s"),
        ("Three tenths of a second", "0.30 s"),
        ("two meters", "2.0 m"),
        ("10m", "10 m"),
        (".5 m", "0.50 m"),
        ("1,000 m", "1000 m"),
        ("12 km", "12 km"),
        ("2.5e-1 m", "0.25 m"),
        ("3 × 10⁻² m", "0.030 m"),
        ("½ m", "0.50 m"),
        ("t=632 s", "t = 632 s"),
        ("t = 9 seconds", "t = 9.0 s"),
        ("0.1 min", "6.0 s"),
        ("30 degrees", "30°"),
        ("3 m/s", "3 m/s"),
        ("9.8 m/s²", "9.8 m/s²"),
        ("4 N·m", "4 N·m"),
        ("0 s", "0 s"),
        ("half as stiff", "half as stiff"),
    ],
)
def test_a_number_is_told_as_the_library_tells_it(written: str, told: str) -> None:
    """A number is converted to the library's unit and digits; numbers in other units stay."""
    assert plainly(f"when it is {written} there", SI) == f"when it is {told} there"
    assert plainly(plainly(written, SI), SI) == plainly(written, SI)


def test_among_planets_in_their_units() -> None:
    """Years and astronomical units are converted, but metres are not."""
    assert plainly("2 years after 0.5 AU and 3 m", ASTRONOMICAL) == "2.0 yr after 0.50 au and 3 m"


@given(st.floats(1e-6, 9e9))
def test_what_is_said_is_heard(value: float) -> None:
    """A number is read back to at least twelve digits."""
    (found,) = numbers_in_text(format_number(value, "s"), "s")
    assert found == pytest.approx(value, rel=1e-12)


@given(st.floats(1e-4, 1e4))
def test_two_digits_stay_two_digits(value: float) -> None:
    """Numbers drawn with two digits are written with two digits."""
    assert format_number(float(two_digits(value)), "s") == f"{two_digits(value)} s"


@pytest.mark.parametrize(
    ("written", "speed"), [("1 m", 1.0), ("0.255 m", 0.255), ("25.5 cm", 0.255), ("half a metre", 0.5)]
)
def test_a_question_has_numbers_of_any_digits(written: str, speed: float) -> None:
    """The speed is given by v² = 2 g sin 30° s."""
    query = parse_question(f"What is the speed of the block after it has moved {written}?", STUDY, WORDS)
    assert query is not None
    assert KINDS[query.kind].answer(query, STUDY) == pytest.approx((9.8 * speed) ** 0.5)
