"""Tests of phrases about slipping, orbits, collisions and the course of a motion."""

import pytest

from sim2reason.questions.ordinary.rewording import reword_question


@pytest.mark.parametrize(
    ("question", "plain"),
    [
        ("what is greatest speed of @0@ in course of its motion", "what is greatest speed of @0@"),
        ("how long does @0@ slip on plane before @0@ starts to roll", "how long does @0@ slip"),
        ("how much energy is lost through sliding friction", "how much energy is lost to friction"),
        ("how many radians per second is @0@ still spinning at when slipping ends", "how fast is @0@ turning when"),
        ("at what rate , in rad/s , is @0@ turning #0# after release", "at what rate is @0@ turning #0# after release"),
        ("reach point of its orbit that is farthest from @1@", "reach point farthest from @1@"),
        (
            "how fast is @0@ moving as @0@ passes place where @1@ is relaxed",
            "how fast is @0@ moving when @1@ is relaxed",
        ),
        ("at what value of x does @0@ cross x axis", "what is x coordinate of @0@ when @0@ cross x axis"),
        ("how hard does plane push on @0@ at right angles to its surface", "how hard does plane push on @0@"),
        ("how much kinetic energy does @0@ acquire in collision", "how much kinetic energy does @0@ gain in collision"),
        ("with what speed does @0@ leave collision", "with what speed does @0@ move just after collision"),
        ("in what time does @0@ go once round @1@", "how long does @0@ take to go once round @1@"),
        ("what distance along top of @0@ has @1@ covered", "what distance does @1@ covered along @0@"),
        ("what is shortest distance between @0@ and @1@", "what is least distance between @0@ and @1@"),
    ],
)
def test_turns_of_phrase_are_replaced_by_plainer_ones(question: str, plain: str) -> None:
    """The reworded question begins with the expected words."""
    assert reword_question(question).startswith(plain)


@pytest.mark.parametrize(
    "question",
    [
        "what is greatest speed of @0@ in course of its second swing",
        "how long does @0@ roll on plane before @0@ starts to slip",
        "how hard does plane push on @0@ parallel to its surface",
        "at what rate , in rev/s , is @0@ turning",
    ],
)
def test_words_that_matter_are_left_in(question: str) -> None:
    """A question about another interval, order, direction or unit is not reworded."""
    assert reword_question(question) == question
