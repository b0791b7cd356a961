"""Tests of the rewording of phrases, and of the removal of words that ask for nothing."""

import pytest

from sim2reason.questions.ordinary.rewording import reword_question
from sim2reason.questions.ordinary.turns_of_order import without_leads


@pytest.mark.parametrize(
    ("question", "plain"),
    [
        ("with what speed does @0@ pass point where @1@ has its natural length", "how fast is @0@ moving when @1@ has"),
        (
            "how high above ground is @0@ as @0@ passes over wall #0# away",
            "how high above ground is @0@ as @0@ passes #0# h",
        ),
        (
            "wall stands #0# in front of thrower. how high is @0@ as @0@ passes over it",
            "how high is @0@ when @0@ has moved",
        ),
        ("find time in which @0@ sinks by #0#", "how long does it take until @0@ sinks by #0#"),
        ("what is time to complete one swing to and fro", "what is time to complete one swing"),
        (
            "how long does @0@ need to swing from its starting position to lowest point",
            "how long does @0@ need to reach low",
        ),
        ("with what acceleration does @0@ slide back down", "what is acceleration of @0@ while @0@ moves down"),
        ("at what rate does @0@ 's speed increase", "what is acceleration of @0@"),
        ("how long does slipping last", "when does slipping stop"),
    ],
)
def test_turns_of_phrase_are_replaced_by_plainer_ones(question: str, plain: str) -> None:
    """The reworded question begins with the expected words."""
    assert reword_question(question).startswith(plain)


@pytest.mark.parametrize(
    ("question", "left"),
    [
        ("okay , find speed of @0@", "find speed of @0@"),
        ("using energy conservation or otherwise , find speed of @0@", "find speed of @0@"),
        ("show that motion is simple harmonic. what is its period", "what is its period"),
        ("what is period. mind that amplitude is not small", "what is period"),
        ("how far is @0@ #0# (#1#) after start", "how far is @0@ #0# after start"),
        ("floor is smooth , so @0@ recoils. how fast is @0@", "how fast is @0@"),
        (
            "what acceleration has @0@ , as measured by observer sitting on @1@",
            "what acceleration has @0@ relative to @1@",
        ),
    ],
)
def test_words_that_ask_for_nothing_are_left_out(question: str, left: str) -> None:
    """Methods, reminders and repeated numbers are left out."""
    assert without_leads(question, ("0.5 s", "0.50 s"), smooth=True) == left


@pytest.mark.parametrize(
    "question",
    [
        "@0@ bounces twice. how high does @0@ rise",
        "how far is @0@ #0# (#2#) after start",
        "mass of @0@ is doubled. what is period",
    ],
)
def test_words_that_matter_are_left_in(question: str) -> None:
    """An event, another number or another scene is not left out."""
    assert without_leads(question, ("0.5 s", "0.50 s", "0.6 s"), smooth=True) == question


def test_a_smooth_floor_is_passed_over_only_where_nothing_rubs() -> None:
    """A sentence that calls a rough floor smooth describes another scene, and stays."""
    told = "floor is smooth. how fast is @0@"
    assert without_leads(told, (), smooth=False) == told
