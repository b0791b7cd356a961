"""Tests of how numbers are written in formulas."""

import pytest

from sim2reason.solutions.algebra.rounded_numbers import pure_number


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (1.0433e-16, r"1.0433 \times 10^{-16}"),
        (-0.25, r"-\tfrac{1}{4}"),
        (3.0, "3"),
        (5026112122006299.0, r"5.0261 \times 10^{15}"),
    ],
)
def test_a_number_is_a_fraction_only_where_it_is_a_simple_one(value: float, text: str) -> None:
    assert pure_number(value) == text
