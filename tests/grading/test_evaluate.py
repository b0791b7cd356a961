import math
import re

import pytest

from sim2reason.grading.formula import compile_formula


def test_a_formula_is_a_function_of_the_symbols_in_it() -> None:
    formula = compile_formula(r"\frac{v_0^{2} \sin\left(2 \theta\right)}{g}", ("m", "v_0", r"\theta", "g"))
    assert formula.symbols == ("v_0", r"\theta", "g")
    point = {"v_0": 3.0, r"\theta": 0.4, "g": 9.8}
    assert formula.value(point) == pytest.approx(9.0 * math.sin(0.8) / 9.8)


@pytest.mark.parametrize(
    "latex",
    [
        r"\left|a - b\left|a\right|\right|",
        r"\lvert a - b \lvert a\rvert\rvert",
        r"\bigl|a - b\,|a|\bigr|",
        "|a - |a| b|",
        "||a| b - a|",
        r"\left(|a - b\left|a\right||\right)",
    ],
)
def test_bars_may_stand_within_bars(latex: str) -> None:
    assert compile_formula(latex, ("a", "b")).value({"a": -2.0, "b": 3.0}) == 8.0


@pytest.mark.parametrize("latex", [r"\left|a - b", r"\left|a \left| b", r"\right| a \right|", "|a| - |b", "||"])
def test_bars_that_are_not_closed_are_refused(latex: str) -> None:
    with pytest.raises(ValueError, match=re.escape(repr(latex))):
        compile_formula(latex, ("a", "b"))


def test_it_has_no_value_where_it_is_not_real() -> None:
    formula = compile_formula(r"\sqrt{a - b}", ("a", "b"))
    assert formula.value({"a": 1.0, "b": 2.0}) is None
    assert formula.value({"a": 2.0, "b": 1.0}) == 1.0


@pytest.mark.parametrize("latex", [r"\frac{a}{", "a + c", "a b x", ""])
def test_what_is_no_formula_in_the_symbols_is_refused(latex: str) -> None:
    with pytest.raises(ValueError, match=re.escape(repr(latex))):
        compile_formula(latex, ("a", "b"))
