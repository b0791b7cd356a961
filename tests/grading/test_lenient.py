"""The last number of a response without a box: what follows it is a unit, a remark or prose, never dropped unread."""

import pytest

from sim2reason.grading import Outcome, number


@pytest.mark.parametrize(
    "text",
    [
        "So a = 9.8.",
        "So a = 9.8 m/s^2 when it lands.",
        "**9.8 m/s²** downward.",
        "The answer is 9.8 m/s^2, which is large.",
        "It is 9.8, as expected",
        "It is 9.8\n\nThat is all there is to say.",
        r"$a = 9.8\ \text{m/s}^2$.",
        "about 9.8 meters per second squared in the end",
        "about 9.8 m/s^2 (to the right)",
    ],
)
def test_what_belongs_to_it_is_read(text: str) -> None:
    assert number(text, 9.8, "m/s^2", lenient=True).reward
    assert number(text, 9.8, "m/s^2").outcome == Outcome.NO_ANSWER


@pytest.mark.parametrize(
    "text",
    [
        "9.8 km or so",
        "9.8 apples",
        "1/9.8",
        "2*9.8",
        r"4\cdot 9.8",
        "4 - 9.8",
        "± 9.8",
        "< 9.8",
        "9.8 km/s^2 in the end",
        "9.8^2",
        "9.8 million",
        "sqrt(9.8)",
    ],
)
def test_what_makes_it_something_else_is_not_dropped(text: str) -> None:
    assert not number(text, 9.8, "m/s^2", lenient=True).reward
