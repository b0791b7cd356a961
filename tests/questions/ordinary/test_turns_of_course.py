"""Tests of phrases about the start, the course and the recurrence of a motion."""

import pytest

from sim2reason.questions.ordinary.rewording import reword_question


@pytest.mark.parametrize(
    ("told", "plain"),
    [
        ("how far does @0@ travel while engine is running", "how far does @0@ travel until burnout"),
        ("how fast is @0@ moving when engine runs dry", "how fast is @0@ moving when fuel runs out"),
        ("how fast does @0@ move off after being hit", "how fast does @0@ move just after @0@ 's first collision"),
        ("how long does @0@ become at most", "what is longest length of @0@"),
        ("how long is @0@ away from its starting point , all told", "how long until @0@ returns"),
        ("how far above ground is @0@ after #0#", "how high above ground is @0@ after #0#"),
        ("what is @0@ 's acceleration as long as strings are taut", "what is @0@ 's acceleration"),
        ("what is speed of @0@ in middle of its oscillation", "what is speed of @0@ at its equilibrium position"),
        (
            "how much kinetic energy is lost in very first collision",
            "how much kinetic energy is lost in first collision",
        ),
        ("what is speed of @0@ after hand has pulled @0@ #0#", "what is speed of @0@ after @0@ has moved #0#"),
    ],
)
def test_a_turn_of_phrase_becomes_plainer(told: str, plain: str) -> None:
    """The plainer words are ones that the parser knows."""
    assert reword_question(told) == plain


@pytest.mark.parametrize(
    "told",
    [
        "how far does @0@ travel while engine is not running",
        "how long is @0@ away from foot of slope",
        "what is speed of @0@ while engine is running",
    ],
)
def test_what_is_no_such_turn_stays(told: str) -> None:
    """A phrase with an additional word is not replaced."""
    assert reword_question(told) == told
