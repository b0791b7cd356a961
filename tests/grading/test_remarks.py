"""Tests of text behind a value: units are not cut, directions keep the sign, and only remarks are remarks."""

import pytest

from sim2reason.grading import Outcome, Score, formula, number, remarks
from sim2reason.grading.score import Refused
from sim2reason.scenes.dsl.units import UnitError, parse_unit


def boxed(answer: str, reference: float, positive: str = "") -> Score:
    return number(rf"So $\boxed{{{answer}}}$.", reference, "m/s", positive=positive)


@pytest.mark.parametrize("word", sorted(remarks.STARTERS))
def test_no_word_that_begins_a_remark_is_a_unit(word: str) -> None:
    with pytest.raises(UnitError):
        parse_unit(word)


WAYS = [("up", "down"), ("right", "left"), ("up the slope", "down the slope"), ("along +x", "along -x")]


@pytest.mark.parametrize(
    ("positive", "ahead", "back"),
    [("up", *WAYS[0]), ("right", *WAYS[1]), ("up the slope", *WAYS[2]), ("along the x axis", *WAYS[3])],
)
@pytest.mark.parametrize(("sign", "value"), [(sign, value) for sign in ("", "+", "-") for value in (3.2, -3.2)])
def test_a_direction_signs_a_bare_magnitude_and_nothing_else(
    positive: str, ahead: str, back: str, sign: str, value: float
) -> None:
    for way, turned in ((ahead, 1), (back, -1)):
        said = {"": turned, "+": 1, "-": -1}[sign] * 3.2
        assert boxed(rf"{sign}3.2\text{{ m/s {way}}}", value, positive).reward == (said == value)


@pytest.mark.parametrize("way", ["to the left", "forward", "up and to the left", "clockwise", "upward, downward"])
def test_a_direction_that_the_question_does_not_tell_is_unreadable(way: str) -> None:
    score = boxed(rf"3.2\text{{ m/s {way}}}", 3.2, "up")
    assert not score.reward
    assert "positive" in score.why or "behind the value" in score.why


def test_a_direction_is_no_sign_where_nothing_tells_which() -> None:
    assert boxed(r"3.2\text{ m/s downward}", 3.2).reward
    score = boxed(r"3.2\text{ m/s downward}", -3.2)
    assert score.outcome == Outcome.UNREADABLE
    assert score.why == "directions stand in place of a sign, and nothing tells which way is positive"


@pytest.mark.parametrize(
    ("tail", "unit", "remark"),
    [
        ("m/s", "m/s", ""),
        ("m/s down", "m/s ", "down"),
        (r"\text{m/s}, up", r"\text{m/s}", ", up"),
        ("(m/s)", "(m/s)", ""),
        ("[m/s] (up)", "[m/s] ", "(up)"),
        ("(tension)", "", "(tension)"),
        (r"m/s \downarrow", "m/s ", r"\downarrow"),
        ("(1/s)", "(1/s)", ""),
        ("(11.5 km/h)", "", "(11.5 km/h)"),
    ],
)
def test_where_a_unit_ends(tail: str, unit: str, remark: str) -> None:
    assert remarks.cut(tail) == (unit, remark)


@pytest.mark.parametrize("text", ["in the", "(not up)", "or 4", "up 4", "(maybe)", "because", "(see figure 2)"])
def test_what_is_no_remark(text: str) -> None:
    with pytest.raises(Refused):
        remarks.read(text)


@pytest.mark.parametrize(
    "text", ["(3 s.f.)", "(to three significant figures)", "(2 d.p.)", "(rounded to 1 decimal place)"]
)
def test_an_accuracy_says_nothing_else(text: str) -> None:
    assert remarks.read(text) == remarks.Remark()


def test_the_same_again_must_agree() -> None:
    assert boxed(r"3.2\text{ m/s }(11.5\text{ km/h})", 3.2).reward
    assert boxed(r"3.2\text{ m/s }(12.5\text{ km/h})", 3.2).outcome == Outcome.WRONG
    assert boxed(r"3.2\text{ m/s }(3.2\text{ kg})", 3.2).outcome == Outcome.WRONG


def test_a_magnitude_with_its_direction_may_stand_behind_a_signed_value() -> None:
    for positive in ("up", ""):
        assert boxed(r"-3.2\text{ m/s (i.e., }3.2\text{ m/s downward)}", -3.2, positive).reward
    assert boxed("-3.2 m/s (3.2 m/s upward)", -3.2, "up").outcome == Outcome.WRONG
    assert boxed("3.2 m/s (3.2 m/s downward)", 3.2, "up").outcome == Outcome.WRONG
    assert boxed("3.2 m/s downward (-3.2 m/s)", -3.2, "up").reward
    assert boxed("-3.2 m/s (3.2 m/s)", -3.2, "up").outcome == Outcome.WRONG
    assert boxed("-3.2 m/s (4 m/s downward)", -3.2).outcome == Outcome.WRONG


@pytest.mark.parametrize(
    ("positive", "ahead", "back"),
    [
        ("counter-clockwise", "counterclockwise", "clockwise"),
        ("anti-clockwise", "counter-clockwise", "clockwise"),
        ("clockwise", "clockwise", "anticlockwise"),
        ("in the \u2212x direction", "in the -x direction", "in the +x direction"),
        ("in the -x direction", "along \u2212x", "along +x"),
        ("along +x", "along +x", "in the negative x direction"),
        ("along $+x$", "along +x", "along -x"),
        ("the positive direction of the x axis", "along +x", "in the negative direction of the x axis"),
        ("along the y-axis", "along +y", "along -y"),
        ("downward", "downward", "upward"),
        ("gain", "gained", "lost"),
        ("an increase", "gain", "loss"),
        ("tension", "stretched", "compressed"),
        ("attraction", "(attractive)", "(repulsive)"),
        ("repulsive", "(repulsion)", "(attraction)"),
    ],
)
def test_the_question_is_read_as_the_answer_is(positive: str, ahead: str, back: str) -> None:
    for way, sign in ((ahead, 1), (back, -1)):
        assert boxed(rf"3.2\text{{ m/s {way}}}", sign * 3.2, positive).reward
        assert boxed(rf"3.2\text{{ m/s {way}}}", -sign * 3.2, positive).outcome == Outcome.WRONG


@pytest.mark.parametrize(
    "signed", ["-{}", "+{}", "\u2013{}", "\u2212{}", "(-{})", r"\left(-{}\right)", r"\frac{{-{}}}{{1}}"]
)
@pytest.mark.parametrize("way", ["up", "down"])
def test_a_direction_never_flips_a_sign_that_is_written(signed: str, way: str) -> None:
    sign = 1 if "+" in signed else -1
    for reference in (1, -1):
        right = sign == reference
        number_said = boxed(rf"{signed.format('3.2')}\text{{ ({way})}}", reference * 3.2, "up")
        formula_said = formula(
            rf"\boxed{{{signed.format('mg')}\text{{ ({way})}}}}", "mg" if reference > 0 else "-mg", positive="up"
        )
        assert (number_said.reward, formula_said.reward) == (right, right)


def test_a_formula_without_symbols_has_directions_too() -> None:
    assert formula(r"\boxed{9.8\text{ down}}", "-9.8", positive="up").reward
    assert formula(r"\boxed{9.8\text{ down}}", "9.8", positive="up").outcome == Outcome.WRONG


@pytest.mark.parametrize("remark", ["(negative)", "negative", "in the negative direction"])
def test_negative_is_no_filler_where_nothing_is_positive(remark: str) -> None:
    assert not boxed(rf"3.2\text{{ m/s {remark}}}", 3.2).reward
    assert not formula(rf"\boxed{{mg\text{{ {remark}}}}}", "mg").reward
    assert boxed(rf"-3.2\text{{ m/s {remark}}}", -3.2).reward
