"""Tests of symbols and brackets in formulas."""

import pytest

from sim2reason.grading import formula

REFERENCE = r"m g \ell \sin\theta + k \ell_0^2"
POINT = {"m": 1.2, "g": 9.8, r"\theta": 0.4, r"\ell": 1.3, r"\ell_0": 0.7, "k": 3.0}
WITH_L = (r"mgl\sin\theta+kl_0^2", "m*g*l*sin(theta)+k*l0**2", r"mg l \sin\theta+k l_{0} l_0")


@pytest.mark.parametrize("answer", [*WITH_L, "m g ℓ sin(θ) + k ℓ₀²", "Abs(m*g*ell*sin(theta)) + k*ell_0**2"])
def test_an_l_is_an_ell_where_it_can_mean_nothing_else(answer: str) -> None:
    assert formula(rf"\boxed{{{answer}}}", REFERENCE, [POINT]).reward == 1.0


@pytest.mark.parametrize("answer", [r"mgL\sin\theta+kL_0^2", r"mgl\sin\theta+kl_1^2"])
def test_no_other_name_is(answer: str) -> None:
    assert formula(rf"\boxed{{{answer}}}", REFERENCE, [POINT]).reward == 0.0


@pytest.mark.parametrize("answer", [*WITH_L, r"mg\ell\sin\theta+kl_0^2"])
def test_an_l_of_the_problem_is_itself(answer: str) -> None:
    assert formula(rf"\boxed{{{answer}}}", REFERENCE, [{**POINT, "l": 2.0}]).reward == 0.0


@pytest.mark.parametrize(
    "answer",
    [
        r"2\left\{a+b\right\}^{-1/2}",
        r"2\{a+b\}^{-\frac12}",
        r"\bigl\{\tfrac14\left[a+b\right]\bigr\}^{-1/2}",
        r"2\lbrace a+b\rbrace^{-1/2}",
        r"2\left\lbrack a+b\right\rbrack^{-1/2}",
        r"2\lparen a+b\rparen^{-1/2}",
    ],
)
def test_brackets_that_print_shows_hold_together(answer: str) -> None:
    r"""Brackets visible in print group *a + b*, unlike the invisible ones of ``\text{…}``."""
    assert formula(rf"\boxed{{{answer}}}", r"\frac{2}{\sqrt{a + b}}", [{"a": 2.0, "b": 3.0}]).reward == 1.0
    assert formula(rf"\boxed{{{answer}}}", r"2 a + b^{-1/2}", [{"a": 2.0, "b": 3.0}]).reward == 0.0


@pytest.mark.parametrize(
    ("answer", "reward"),
    [
        (r"h\ \text{m}", 1.0),
        (r"h\,\mathrm{kg}\cdot\mathrm{m}", 1.0),
        (r"h\ \text{m} g", 0.0),  # the unit could be m·g, but g is a symbol of the problem
        (r"h\ \text{N} m", 0.0),
        (r"h\ \text{m} \%", 0.0),
        (r"h\ \text{m}^\circ", 0.0),
        (r"h\ \text{apples}", 0.0),
        (r"h \%", 0.0),
        ("h m", 0.0),
    ],
)
def test_only_an_upright_unit_may_follow(answer: str, reward: float) -> None:
    assert formula(rf"\boxed{{{answer}}}", "h", symbols=["h", "g"]).reward == reward
