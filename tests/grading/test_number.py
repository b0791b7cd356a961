r"""Tests of single numbers: what may stand behind them, what repeats them, and the limits of the arguments."""

from math import inf, nan

import pytest

from sim2reason.grading import Outcome, number


@pytest.mark.parametrize(
    ("answer", "reference", "unit", "outcome"),
    [
        ("0.42:1", 0.42, "", "correct"),
        ("0.42 : 1", 0.42, None, "correct"),
        ("0.42:1", 0.42, "m", "unreadable"),
        ("0.42:2", 0.42, "", "unreadable"),
        ("0.42:10", 0.42, "", "unreadable"),
        ("3 1/s", 3.0, "1/s", "correct"),
        ("3 2/s", 3.0, "1/s", "unreadable"),
        ("2 h 30 min", 2.5, "h", "correct"),
        ("-2 h 30 min", -2.5, "h", "correct"),
        ("2 h 30 min", 1.5, "h", "wrong"),
        (r"26^\circ 30'", 26.5, "deg", "correct"),
        (r"-26^\circ 30'", -26.5, "deg", "correct"),
        ("5 %", 0.05, None, "correct"),
        ("5 %", 5.0, None, "wrong"),
        ("5 %", 0.05, "", "correct"),
        ("5 rad", 5.0, None, "correct"),
        ("5 kg", 5.0, None, "correct"),
        ("5 kg", 5.0, "", "wrong unit"),
        ("1e400", 1.0, None, "wrong"),
        ("1/0", 1.0, None, "wrong"),
    ],
)
def test_what_stands_behind_a_number_is_a_unit_or_refused(
    answer: str, reference: float, unit: str | None, outcome: str
) -> None:
    assert number(rf"\boxed{{{answer}}}", reference, unit, tolerance=1e-9).outcome == outcome


@pytest.mark.parametrize(
    ("answer", "positive", "value"),
    [
        ("9.8 N (9.8 N)", "", 9.8),
        ("9.8 N (10.2 N)", "", 9.8),  # two sides of an equation may differ by 5 %
        ("9.8 N (10.4 N)", "", None),
        ("9.8 N (9.8 N downward)", "", 9.8),
        ("9.8 N (-9.8 N downward)", "", None),
        ("-9.8 N (9.8 N downward)", "", -9.8),
        ("-9.8 N (9.8 N downward)", "upward", -9.8),
        ("9.8 N (9.8 N downward)", "upward", None),
        ("9.8 N (9.8 N upward)", "upward", 9.8),
        ("9.8 N downward (-9.8 N)", "upward", -9.8),
        ("-9.8 N (-9.8 N downward)", "upward", -9.8),
        ("9.8 N (-9.8 N downward)", "upward", None),
        ("0.5 N downward", "upward", -0.5),
        ("0.5 N upward", "upward", 0.5),
        ("-0.5 N downward", "upward", -0.5),
        ("0.5 N", "upward", 0.5),
        ("0.5 N downward", "", 0.5),
    ],
)
def test_a_value_in_brackets_repeats_the_one_before_it(answer: str, positive: str, value: float | None) -> None:
    response = rf"\boxed{{{answer}}}"
    for reference in (9.8, -9.8, 0.5, -0.5):
        assert bool(number(response, reference, "N", positive=positive).reward) is (reference == value)


@pytest.mark.parametrize("arguments", [(nan, 0.05), (inf, 0.05), (-inf, 0.05), (1.0, 1.0), (1.0, -1e-9), (1.0, nan)])
def test_other_references_and_tolerances_are_errors(arguments: tuple[float, float]) -> None:
    with pytest.raises(ValueError, match=r"finite and the tolerance in \[0, 1\)"):
        number(r"\boxed{1}", arguments[0], tolerance=arguments[1])


@pytest.mark.parametrize(
    ("answer", "tolerance", "right"),
    [
        ("8", 0.0, True),
        ("8.0001", 0.0, False),
        ("7", 0.125, True),
        ("9", 0.125, True),
        ("9.01", 0.125, False),
        ("6.99", 0.125, False),
        ("0.1", 0.99, True),
        ("0.07", 0.99, False),
    ],
)
def test_the_tolerance_is_relative_to_the_reference_and_counts_at_its_limit(
    answer: str, tolerance: float, right: bool
) -> None:
    score = number(rf"\boxed{{{answer}}}", 8.0, tolerance=tolerance)
    assert score.outcome is (Outcome.CORRECT if right else Outcome.WRONG)
    assert score.why == f"the answer is {answer}; expected 8 within {100 * tolerance:g} %"


@pytest.mark.parametrize(
    ("answer", "unit", "why"),
    [
        ("50 cm", "m", "50 cm is 0.5 m; expected 0.5 m within 5 %"),
        ("0.5", "m", "the answer is 0.5 m; expected 0.5 m within 5 %"),
        ("0.5 m", "m", "the answer is 0.5 m; expected 0.5 m within 5 %"),
        ("0.5 kg", "m", "0.5 kg is no quantity in m; expected 0.5 m within 5 %"),
        ("0.5 kg", "", "0.5 kg is no pure number; expected 0.5 within 5 %"),
        ("50 %", None, "50 % is 0.5; expected 0.5 within 5 %"),
    ],
)
def test_the_reason_shows_the_value_in_the_requested_unit(answer: str, unit: str | None, why: str) -> None:
    assert number(rf"\boxed{{{answer}}}", 0.5, unit).why == why


@pytest.mark.parametrize(
    ("answer", "reward"),
    [
        ("50 m = 0.05 km", 1.0),
        ("50 m = 0.05", 1.0),
        ("0.05 = 50 m", 1.0),
        ("5000 cm = 0.05", 1.0),
        ("50 = 0.05 km", 1.0),
        ("60 m = 0.05", 0.0),
        ("50 = 0.05", 1.0),  # 50 m are meant
        ("0.05 km = 50", 0.0),  # the last value counts
        ("50 km = 0.05", 0.0),
        ("0.05 = 50 km", 0.0),
        ("50 cm = 0.05", 0.0),
        ("0.5 m = 0.05", 0.0),
    ],
)
def test_two_sides_agree_in_some_unit(answer: str, reward: float) -> None:
    """A bare number is in the requested unit, the other side's unit, or its SI unit."""
    assert number(rf"\boxed{{{answer}}}", 0.05, "km").reward == reward
