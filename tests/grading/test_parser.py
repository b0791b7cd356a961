r"""Tests of nesting in answers: how deep it may be, and that what ends does not count."""

import pytest

from sim2reason.grading import Outcome, number

DEPTH = 32
LEVELS = [
    ("(", ")", 1),
    ("[", "]", 1),
    (r"\{", r"\}", 1),
    (r"\left|", r"\right|", 1),
    ("1^", "", 1),
    (r"\sin ", "", 1),
    (r"\sin(", ")", 2),
    (r"\sqrt{", "}", 2),
    (r"\frac{", "}{1}", 2),
    ("1^{", "}", 2),
]
"""What opens and closes one level, and by how much it deepens an answer."""

TWOS = [
    "2^{1}",
    "2^1",
    "2¹",
    "2^{1^1}",
    r"2^{-1}\cdot 4",
    "(2)",
    r"\left(2\right)",
    "|2|",
    "|{-2}|",
    r"\frac{4}{2}",
    r"\frac42",
    r"\frac{2\pi}\pi",
    r"\sqrt{4}",
    r"\sqrt[2]{4}",
    "√4",
    r"\sqrt\pi\sqrt\pi\frac{2}{\pi}",
    r"2\sin(90^\circ)",
    r"2\sin^2(90^\circ)",
    r"2\sin^{-1}(0.8414709848)",
]
"""Spellings of the number 2 with something nested."""


@pytest.mark.parametrize(("opening", "closing", "depth"), LEVELS)
def test_an_answer_may_be_nested_so_deep_and_no_deeper(opening: str, closing: str, depth: int) -> None:
    count = DEPTH // depth
    for levels, too_long in ((count, False), (count + 1, True)):
        score = number(rf"\boxed{{{opening * levels}1{closing * levels} + 0}}", 1.0)
        assert (score.outcome is Outcome.TOO_LONG) is too_long


@pytest.mark.parametrize(("opening", "closing", "depth"), LEVELS)
def test_levels_side_by_side_are_not_nested(opening: str, closing: str, depth: int) -> None:
    one = f"{opening}1{closing}"
    assert number(rf"\boxed{{{' + '.join([one] * (DEPTH + 1))}}}", 1.0).outcome is not Outcome.TOO_LONG
    count = DEPTH // depth + 1
    score = number(rf"\boxed{{{one} + {opening * count}1{closing * count}}}", 1.0)
    assert score.outcome is Outcome.TOO_LONG


@pytest.mark.parametrize("two", TWOS)
def test_a_degree_sign_at_the_end_is_the_unit(two: str) -> None:
    """Only within brackets does a degree sign turn a number into radians."""
    for answer in (rf"{two}\cdot 15^\circ", rf"15\cdot {two}^\circ"):
        assert number(rf"\boxed{{{answer}}}", 30.0, "deg", tolerance=1e-9).reward, answer


@pytest.mark.parametrize("two", TWOS)
def test_a_number_behind_what_was_nested_is_no_factor(two: str) -> None:
    assert number(rf"\boxed{{{two} 3}}", 6.0).outcome is Outcome.UNREADABLE
