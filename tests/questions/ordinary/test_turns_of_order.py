"""Tests of phrases in an unusual order of words."""

import pytest

from sim2reason.questions.ordinary.rewording import reword_question


@pytest.mark.parametrize(
    ("told", "plain"),
    [
        (
            "how fast is @0@ moving when , on its way down , @0@ is #0# above ground",
            "how fast is @0@ moving when @0@ is #0# above ground on its way down",
        ),
        (
            "what kinetic energy , translation and rotation together , does @0@ have at start",
            "what kinetic energy does @0@ have at start",
        ),
        ("@0@ passes @1@ for first time after how many years", "how long until @0@ passes @1@ for first time"),
        ("how long is year on this @0@", "what is period of @0@"),
        (
            "how much heat does rubbing of @0@ on @1@ generate in first #0#",
            "how much heat arises between @0@ and @1@ in first #0#",
        ),
        ("how much higher is @0@ than at start when @0@ moves", "how far vertically higher is @0@ when @0@ moves"),
        ("how fast is @0@ when @1@ are farthest apart", "how fast is @0@ when @1@ are farthest"),
        ("how long does engine keep running", "how long does engine burn"),
        (
            "how large is component of @0@ 's velocity along y after impact",
            "how large is y component of velocity of @0@ after impact",
        ),
        ("up to what length does @0@ get stretched", "what is longest length of @0@"),
    ],
)
def test_a_turn_of_phrase_becomes_plainer(told: str, plain: str) -> None:
    """The plainer words are ones that the parser knows."""
    assert reword_question(told) == plain


@pytest.mark.parametrize(
    "told",
    [
        "what kinetic energy , rotation excluded , does @0@ have",
        "how much heat does rubbing of @0@ on floor generate",
        "how long is day on this @0@",
    ],
)
def test_what_is_no_such_turn_stays(told: str) -> None:
    """A phrase with an additional word is not replaced."""
    assert reword_question(told) == told
