"""Tests of what a text alone says about its last line."""

from math import sin

import pytest

from sim2reason.testing.solution_text import read

SINE = -1.3 / 3.0 * sin(40.0 * 2.35574)
KNOWN = {"m": 2.0, "u": 1.5, "v": 4.0}


def ending(formula: str) -> str:
    return r"The impulse is $J = m \left(v - u\right)$." + "\n\n" + rf"Answer: $J = \boxed{{{formula}}}$."


def test_a_magnitude_of_a_sum_is_read() -> None:
    told = read(ending(r"\left|m u - m v\right|"), KNOWN)
    assert not told.unread
    assert not told.broken
    assert read(ending(r"\left|m u + m v\right|"), KNOWN).broken


def test_roots_within_fractions_within_roots_are_read() -> None:
    """J = m (v − u) = √(√(m⁴ (v − u)⁴)), at any depth."""
    deep = r"\sqrt{\frac{\sqrt{m^{4} \left(v %s u\right)^{\frac{8}{2}}}}{1}}"
    right, wrong = (read(ending(deep % sign), KNOWN) for sign in "-+")
    assert not right.unread
    assert not right.broken
    assert wrong.broken


def test_a_last_line_that_can_not_be_read_is_told() -> None:
    assert read(ending(r"\left|m u - m v"), KNOWN).unread


def test_a_number_without_a_value_follows_from_what_rounding_spoils_least() -> None:
    """b sin(w t) hardly determines b if the sine is close to zero, as t has five digits only."""
    told = r"$a = 2.0000$, $c = 1.3000$, $w = 40.000$ and $t = 2.3557$"
    means, wave = r"$b = \frac{a c}{3}$", rf"$b \sin\left(w t\right) + {SINE:.7f}\,a = 0$"
    for text in (f"{told}: {means}, {wave}.", f"{told}: {wave}, {means}."):
        assert read(text).values["b"] == pytest.approx(2.6 / 3.0)
        assert not read(text).broken


@pytest.mark.parametrize(("number", "law", "broken"), [("3.0000", "m g", False), ("3.0000", "2 m g", True)])
def test_a_law_goes_on_holding_in_a_sum_where_its_result_is_said_too(number: str, law: str, broken: bool) -> None:
    """N = m g = 3.0 N is substituted into the sum like N = m g alone."""
    text = (
        "Given: $m = 1.5$, $g = 2.0$ and $F = 7.0$.\n\n"
        f"Perpendicular to the surface, block A: $N = m g = {number}$.\n\n"
        "(1) Block B: $F - T = m a$. (2) Block A: $T - N = m a$.\n\n"
        f"(1) + (2): $F - {law} = 2 m a$.\n\nSo $a = 1.3333$.\n\nThen $T = 5.0000$."
    )
    assert any(held.startswith("(1) + (2)") or "2 m a" in held for held in read(text).broken) is broken
