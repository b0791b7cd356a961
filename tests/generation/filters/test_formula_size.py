"""Tests of the least number of symbols in a formula, by equal formulas in different forms."""

import pytest

from sim2reason.generation.filters.well_known import has_logarithm, size
from sim2reason.solutions.algebra.expressions import Expression, Number, Symbol
from sim2reason.solutions.algebra.functions import Call, Power, Root

M, m, F, g, k, t, x, y = map(Symbol, "MmFgktxy")
SINE = Call("sin", Symbol(r"\theta"))


@pytest.mark.parametrize(
    ("whole", "count"),
    [
        pytest.param((M * g * SINE + F + m * g * SINE) / (M + m) * t, 6, id="F/(M + m) + g sin θ, for a time t"),
        pytest.param(g * (M + m) * SINE / (M + m), 2, id="g sin θ"),
        pytest.param((M * g - m * g) / (M + m), 5, id="g (M - m)/(M + m)"),
        pytest.param(k * Root(Power(x, 2) + Power(y, 2)) / m, 3, id="the length of a stated vector is one"),
        pytest.param(k * Root(Power(x - t, 2) + Power(y - F, 2)), 2, id="and so is the distance of two points"),
        pytest.param(Root(Power(x * k, 2) + Power(y, 2)), 3, id="but not what is no vector of the text"),
        pytest.param(x * Root(k / m) * Call("sin", Root(k / m) * t), 5, id="a root that stands there again is one"),
        pytest.param(Number(0.5) * m * Power(t, 2), 2, id="a power stands there once"),
    ],
)
def test_it_counts_what_cannot_be_left_out(whole: Expression, count: int) -> None:
    assert size(whole) == count


def test_a_logarithm_is_found_at_any_depth() -> None:
    assert has_logarithm(m * Call("ln", M / m) - t)
    assert not has_logarithm(m * SINE)
