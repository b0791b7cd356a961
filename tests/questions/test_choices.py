"""Tests of the questions about a motion that are worth asking: instants, and components against magnitudes."""

import pytest

from motions import MOTIONS
from sim2reason.questions.choices import has_formula_of_time
from sim2reason.questions.query import targets


@pytest.mark.parametrize(
    ("name", "known"),
    [
        ("orbit", False),
        ("rod_pendulum", False),
        ("spring_block", True),
        ("string_pendulum", False),
        ("thrown_ball", True),
    ],
)
def test_instants_are_asked_about_only_where_a_formula_tells_what_happens(name: str, *, known: bool) -> None:
    assert has_formula_of_time(MOTIONS[name]().told()[0].mechanism) is known


def test_the_range_of_a_throw_is_asked_for_more_often_than_a_slanted_distance() -> None:
    words = MOTIONS["thrown_ball"]().told()[1]
    shares = {noun.phrase: target.share for target, noun in targets(words).items() if target.quantity == "displacement"}
    level = next(share for phrase, share in shares.items() if "horizontal" in phrase)
    slanted = next(share for phrase, share in shares.items() if phrase.startswith("the distance between"))
    assert level > 5.0 * slanted
