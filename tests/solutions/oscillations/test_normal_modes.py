"""Tests of rows of carts: when the common motion doesn't contribute, and the source of displacement ratios."""

from worked import solution_text


def test_the_common_motion_is_named_and_shown_not_to_be_excited() -> None:
    text = solution_text("chain-hard-multipart-301917-1")
    assert "Mode 1 is the common motion of all bodies. The total momentum is zero" in text
    assert r"$r_{B,2} = \frac{" in text
