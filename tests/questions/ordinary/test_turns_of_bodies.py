"""Tests of phrases such as *their common velocity*, about values, paths and pairs of bodies."""

import pytest

from sim2reason.questions.ordinary.rewording import reword_question


@pytest.mark.parametrize(
    ("told", "plain"),
    [
        ("what velocity do @0@ have in common when @0@ touch", "what is common speed of @0@ when @0@ touch"),
        ("find heat produced by friction at both rubbing surfaces together", "find heat produced by friction in all"),
        ("@0@ moves in circle. calculate @0@ 's radius", "what is radius of path of @0@"),
        ("how short is @0@ when @1@ stops", "how long is @0@ when @1@ stops"),
        ("what is tension in @0@ between them", "what is tension in @0@"),
        ("how far does @0@ descend at most", "how far does @0@ descend before @0@ stops"),
        ("what is longest @0@ gets", "what is longest length of @0@"),
        ("what is distance of @0@ from origin", "what is distance from origin of @0@"),
        ("how close to origin does @0@ come", "what is least distance from origin of @0@"),
        ("how far from stop is @0@ at start", "how far from far end is @0@ at start"),
    ],
)
def test_a_turn_of_phrase_becomes_plainer(told: str, plain: str) -> None:
    """The plainer words are ones that the parser knows."""
    assert reword_question(told) == plain


@pytest.mark.parametrize(
    "told",
    [
        "what velocity do @0@ nearly have in common when @0@ touch",
        "@0@ moves in circle. calculate half @0@ 's radius",
        "what is speed of @0@ after rebounding from wall",
    ],
)
def test_what_is_no_such_turn_stays(told: str) -> None:
    """A phrase with an additional word is not replaced."""
    assert reword_question(told) == told
