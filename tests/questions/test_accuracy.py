"""Tests of results as questions state them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sim2reason.questions.accuracy import StatedResult


@given(st.floats(1e-6, 1e7), st.sampled_from([1.0, -1.0]), st.integers(2, 3))
def test_what_is_stated_is_found_again(size: float, sign: float, digits: int) -> None:
    """Values just below a power of ten, to which they may be rounded, are included."""
    for value in (sign * size, sign * 10.0 ** round(size % 6) * (1.0 - 1e-6)):
        stated = StatedResult.rounded(value, "m", digits)
        if stated is not None:
            assert stated.value == pytest.approx(value, rel=0.5 * 10.0 ** (1 - digits))
            assert [*StatedResult.find_in_text(f"it is {stated.text} away", "m")] == [stated]


def test_what_is_too_large_to_be_said_plainly_is_not_stated() -> None:
    assert StatedResult.rounded(99_970.0, "m", 3) is None
    assert StatedResult.rounded(99_940.0, "m", 3) == StatedResult("99900", "m")
    assert StatedResult.rounded(0.0, "m", 3) is None
