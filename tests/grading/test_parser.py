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


@pytest.mark.parametrize(
    ("answer", "value"),
    [
        (r"3\frac{\pi}{2}", 4.71238898038469),
        (r"3\frac\pi 2", 4.71238898038469),
        (r"3\frac{1}{\pi}", 0.954929658551372),
        (r"3\frac12", None),
        (r"3\frac{1}{2}", None),
        (r"3\frac1{2}", None),
        (r"3\frac{12}{5}", None),
        (r"5 - 3\frac{1}{2}", None),
        ("1½", None),
        (r"2^3\frac12", 4.0),
        (r"2^{3}\frac{1}{2}", 4.0),
        ("2^3½", None),
        (r"\pi\frac12", 1.5707963267948966),
    ],
)
def test_a_whole_number_beside_a_fraction_of_whole_numbers_is_refused(answer: str, value: float | None) -> None:
    """It could be a sum, as in one and a half, or a product; beside an exponent it is a product."""
    score = number(rf"\boxed{{{answer}}}", value or 1.0, tolerance=1e-9)
    assert score.outcome is (Outcome.UNREADABLE if value is None else Outcome.CORRECT), score.why


@pytest.mark.parametrize(
    ("answer", "value"),
    [
        ("3(2)", 6.0),
        ("3(.5)", 1.5),
        ("3((2))", 6.0),
        ("3({2})", 6.0),
        ("3{(2)}", 6.0),
        ("3{{(2)}}", 6.0),
        (r"3{\sqrt4}", 6.0),
        (r"3{{\sqrt4}}", 6.0),
        (r"3{\frac42}", 6.0),
        ("3{2}", None),
        ("3{{2}}", None),
        ("3{{{2}}}", None),
        ("3{.5}", None),
        ("3{{.5}}", None),
        ("{3}{2}", None),
        ("3()", None),
        ("{2}^2", 4.0),
        ("{23}^2", 529.0),
        ("{(2)}^2", 4.0),
        (r"{\sqrt4}^2", 4.0),
        (r"{2\cdot 3}^2", None),
        ("{2^2}^2", None),
        ("{-2}^2", None),
        ("{2}²", 4.0),
        (r"{2\cdot 3}²", None),
        (r"2\cdot{2+3}", None),
    ],
)
def test_braces_are_read_as_they_print(answer: str, value: float | None) -> None:
    """Print shows no braces, so that they neither multiply digits nor hold together a power."""
    score = number(rf"\boxed{{{answer}}}", value or 6.0, tolerance=1e-9)
    assert score.outcome is (Outcome.UNREADABLE if value is None else Outcome.CORRECT), score.why


@pytest.mark.parametrize(
    ("answer", "value"),
    [
        (r"\frac 12", 0.5),
        (r"\frac12\cdot 3", 1.5),
        (r"\frac1{25}", 0.04),
        (r"\frac{25}1", 25.0),
        (r"\frac\pi4", 0.7853981633974483),
        (r"\sqrt4", 2.0),
        (r"\sqrt{44.1}", 6.640783086353597),
        ("√4", 2.0),
        ("√44", 6.6332495807108),
        ("√{44}", 6.6332495807108),
        (r"\frac122", None),
        (r"\frac1.52", None),
        (r"\frac1,000 2", None),
        (r"\sqrt44", None),
        (r"\sqrt 4.5", None),
        (r"\frac{1}", None),
        (r"\frac{}{2}", None),
    ],
)
def test_a_command_takes_one_digit_or_a_group(answer: str, value: float | None) -> None:
    score = number(rf"\boxed{{{answer}}}", value or 1.0, tolerance=1e-9)
    assert score.outcome is (Outcome.UNREADABLE if value is None else Outcome.CORRECT), score.why


@pytest.mark.parametrize(
    ("answer", "outcome"),
    [
        ("2x10^3", "correct"),
        ("2 X 10³", "correct"),
        ("2 x 10^{3}", "correct"),
        ("2 x 11^3", "unreadable"),
        ("2 y 10^3", "unreadable"),
        ("2 x 2000", "unreadable"),
        ("200 x 10", "unreadable"),
    ],
)
def test_an_x_multiplies_by_a_power_of_ten_only(answer: str, outcome: str) -> None:
    assert number(rf"\boxed{{{answer}}}", 2000.0).outcome == outcome
