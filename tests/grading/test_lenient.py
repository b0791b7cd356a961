"""Tests of the last number of a response without a box, whose unit, remark or prose is always read."""

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
        r"The answer is \(9.8\ \text{m/s}^2\).",
        "<answer>9.8</answer>",
        "9.8 m/s^2<|im_end|>",
        "9.8 m/s² (2 s.f.)",
        '{"answer": 9.8}',
        '{"reasoning": "2 + 2", "answer": "9.8 m/s^2", "confidence": 1}',
        "| a | 9.8 m/s² |",
        "* 9.8 m/s^2",
        "Plugging in, we get a = 9.8 m/s^2",
        "a = 9.8 m/s². Let me know if you have 1 more question!",
        "We do not need the mass, so a = 9.8",
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
        "between 9.7 and 9.8",
        "from 4.9 to 9.8",
        "4.9 or 9.8",
        "7, 8, 9, 9.8",
        "x = 4.9, y = 9.8",
        "not 9.8",
        "The answer is 4.9, not 9.8.",
        "The answer isn't 9.8",
        "at most 9.8",
        "less than 9.8",
        "maybe 9.8",
        "half of 9.8",
        "The previous value: 9.8",
        "2a = 9.8",
        "So we find 2 a = 9.8",
        "9.8 is wrong",
        "- 9.8",
        '{"answer": 4.9} 9.8',
        "<answer>4.9</answer> 9.8",
    ],
)
def test_what_makes_it_something_else_is_not_dropped(text: str) -> None:
    assert not number(text, 9.8, "m/s^2", lenient=True).reward


@pytest.mark.parametrize(
    ("text", "outcome", "why"),
    [
        ("It is 9.8 apples", "unreadable", "'apples' after the value"),
        ("9.8 million.", "unreadable", "'million' after the value"),
        ("Mass: 2 kg. The height is 9.8 kg", "wrong unit", "9.8 kg is no quantity in m"),
        ("no number at all", "no answer", "there is neither a box nor a number"),
    ],
)
def test_the_reason_is_what_is_wrong_with_the_whole_sentence(text: str, outcome: str, why: str) -> None:
    score = number(text, 9.8, "m", lenient=True)
    assert score.outcome == outcome
    assert why in score.why
